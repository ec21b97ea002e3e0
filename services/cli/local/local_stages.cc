#include "services/cli/local/local_stages.h"

#include "services/beading/algo/local_beading_stage.h"
#include "services/exposure/algo/local_exposure_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/milling/algo/local_milling_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/planning/algo/local_planning_stage.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/slicing/algo/placement/local_placing_stage.h"
#include "services/texture/algo/local_texture_stage.h"

namespace slicefarm::cli {

LocalStages::LocalStages()
    : slicing_(slicing::MakeLocalSlicing()),
      planning_(planning::MakeLocalPlanning()),
      beading_(beading::MakeLocalBeading()),
      infill_(infill::MakeLocalInfill()),
      ordering_(ordering::MakeLocalOrdering()),
      motion_(motion::MakeLocalMotion()),
      exposure_(exposure::MakeLocalExposure()),
      placing_(slicing::MakeLocalPlacing()),
      milling_(milling::MakeLocalMilling()),
      texture_(texture::MakeLocalTexture()) {}

Stages LocalStages::all() const {
  return {slicing_.get(), planning_.get(), beading_.get(), infill_.get(),  ordering_.get(),
          motion_.get(),  exposure_.get(), placing_.get(), milling_.get(), texture_.get()};
}

}  // namespace slicefarm::cli
