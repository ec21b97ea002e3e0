#pragma once

#include <memory>

#include "common/stage/milling_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::milling {

/// The milling stage in this process; README.md lists its steps. Errors: those of PrepareMilling,
/// MillSteps, AssembleProgram and ReportOf; SETTING_OUT_OF_RANGE for a picture of a step that the
/// job has not.
std::unique_ptr<MillingStage> MakeLocalMilling();

}  // namespace slicefarm::milling
