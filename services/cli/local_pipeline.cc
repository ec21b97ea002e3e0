#include "services/cli/local_pipeline.h"

#include "services/beading/algo/local_beading_stage.h"
#include "services/exposure/algo/local_exposure_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/planning/algo/local_planning_stage.h"
#include "services/slicing/algo/local_slicing_stage.h"

namespace slicefarm::cli {

LocalPipeline::LocalPipeline(int threads)
    : slicing_(slicing::MakeLocalSlicing()),
      planning_(planning::MakeLocalPlanning()),
      beading_(beading::MakeLocalBeading()),
      infill_(infill::MakeLocalInfill()),
      ordering_(ordering::MakeLocalOrdering()),
      motion_(motion::MakeLocalMotion()),
      exposure_(exposure::MakeLocalExposure()),
      fdm_chain_(*beading_, *infill_, *ordering_, *motion_),
      laser_chain_(*exposure_),
      fdm_(*slicing_, *planning_, *motion_),
      laser_(*slicing_, *exposure_),
      pipeline_({&fdm_, &laser_}, dispatcher_) {
  const std::vector<const TaskRunner*> chains = {&fdm_chain_, &laser_chain_};
  dispatcher_.Join(
      {.name = "here", .tasks = std::make_shared<ProcessRunners>(chains), .slots = threads});
}

}  // namespace slicefarm::cli
