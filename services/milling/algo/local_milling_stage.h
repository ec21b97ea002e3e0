#pragma once

#include <memory>

#include "common/stage/milling_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::milling {

/// Returns the milling stage that runs in this program; README.md lists its steps. Errors: any
/// error of PrepareMilling, MillSteps, AssembleProgram and ReportOf; SETTING_OUT_OF_RANGE if a
/// picture is requested of a step that the job does not have.
std::unique_ptr<MillingStage> MakeLocalMilling();

}  // namespace slicefarm::milling
