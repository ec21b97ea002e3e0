#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Parts inside the region of the lines that planning has laid out for the layer (adaptive and
/// support cubic, lightning: services/planning/algo/infill). Pitch and angle of the PatternPlace
/// are ignored.
MakePattern PlannedLines;

}  // namespace slicefarm::infill
