#pragma once

#include <memory>

#include "common/stage/stages.h"
#include "processes/fdm/job/fdm_process.h"
#include "processes/fdm/task/layer_chain.h"
#include "processes/laser/job/laser_process.h"
#include "processes/laser/task/laser_chain.h"
#include "services/coordinator/algo/dispatch/dispatcher.h"
#include "services/coordinator/algo/pipeline/job_pipeline.h"

namespace slicefarm::cli {

/// The whole pipeline in this process: the stages' algorithms, called directly by `threads`
/// threads.
class LocalPipeline {
 public:
  explicit LocalPipeline(int threads);

  const coordinator::JobPipeline& pipeline() const { return pipeline_; }

 private:
  // In this order: the pipeline refers to the stages and the dispatcher, whose threads run the
  // chain.
  std::unique_ptr<SlicingStage> slicing_;
  std::unique_ptr<PlanningStage> planning_;
  std::unique_ptr<BeadingStage> beading_;
  std::unique_ptr<InfillStage> infill_;
  std::unique_ptr<OrderingStage> ordering_;
  std::unique_ptr<MotionStage> motion_;
  std::unique_ptr<ExposureStage> exposure_;
  LayerChain fdm_chain_;
  LaserChain laser_chain_;
  coordinator::Dispatcher dispatcher_;
  coordinator::FdmProcess fdm_;
  coordinator::LaserProcess laser_;
  coordinator::JobPipeline pipeline_;
};

}  // namespace slicefarm::cli
