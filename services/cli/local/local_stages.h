#pragma once

#include <memory>

#include "common/stage/beading_stage.h"
#include "common/stage/exposure_stage.h"
#include "common/stage/infill_stage.h"
#include "common/stage/milling_stage.h"
#include "common/stage/motion_stage.h"
#include "common/stage/ordering_stage.h"
#include "common/stage/planning_stage.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "common/stage/texture_stage.h"

namespace slicefarm::cli {

/// All stages in this program: their algorithms, called directly.
class LocalStages {
 public:
  LocalStages();

  /// Returns all stages.
  Stages all() const;

 private:
  const std::unique_ptr<SlicingStage> slicing_;
  const std::unique_ptr<PlanningStage> planning_;
  const std::unique_ptr<BeadingStage> beading_;
  const std::unique_ptr<InfillStage> infill_;
  const std::unique_ptr<OrderingStage> ordering_;
  const std::unique_ptr<MotionStage> motion_;
  const std::unique_ptr<ExposureStage> exposure_;
  const std::unique_ptr<PlacingStage> placing_;
  const std::unique_ptr<MillingStage> milling_;
  const std::unique_ptr<TextureStage> texture_;
};

}  // namespace slicefarm::cli
