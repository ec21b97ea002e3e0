#pragma once

#include <memory>

#include "common/stage/motion_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::motion {

/// Returns the motion stage in this program: ProgramLayer for each layer, FrameProgram. The stage
/// is stateless.
std::unique_ptr<MotionStage> MakeLocalMotion();

}  // namespace slicefarm::motion
