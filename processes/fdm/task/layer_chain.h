#pragma once

#include <memory>
#include <vector>

#include "common/stage/beading_stage.h"
#include "common/stage/infill_stage.h"
#include "common/stage/motion_stage.h"
#include "common/stage/ordering_stage.h"
#include "processes/fdm/task/fdm_task.h"

namespace slicefarm {

/// The four layer stages in sequence, each local or remote. The stages must outlive the chain.
class LayerChain : public FdmRunner {
 public:
  LayerChain(const BeadingStage& beading, const InfillStage& infill, const OrderingStage& ordering,
             const MotionStage& motion)
      : beading_(beading), infill_(infill), ordering_(ordering), motion_(motion) {}

  /// Returns the chain, or null if one of the stages is missing.
  static std::shared_ptr<const LayerChain> Over(const Stages& stages);
  static std::vector<Stage> StagesOf();

  absl::StatusOr<FdmResult> Run(const StageCall& call, const FdmTask& task) const override;

 private:
  const BeadingStage& beading_;
  const InfillStage& infill_;
  const OrderingStage& ordering_;
  const MotionStage& motion_;
};

}  // namespace slicefarm
