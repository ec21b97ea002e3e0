#pragma once

#include <memory>

#include "common/stage/motion_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::motion {

/// Returns the motion stage that runs in this program. It calls ProgramLayer for each layer, and
/// FrameProgram for the text around the layers. The stage is stateless.
std::unique_ptr<MotionStage> MakeLocalMotion();

}  // namespace slicefarm::motion
