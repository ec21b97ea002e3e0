#include "services/cli/local_pipeline.h"

#include "services/beading/algo/local_beading_stage.h"
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
      fdm_(*slicing_, *planning_, *motion_),
      pipeline_({&fdm_}, dispatcher_) {
  dispatcher_.Join(
      {.name = "here",
       .tasks = std::make_shared<LayerChain>(*beading_, *infill_, *ordering_, *motion_),
       .slots = threads});
}

}  // namespace slicefarm::cli
