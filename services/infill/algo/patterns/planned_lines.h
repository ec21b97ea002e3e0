#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Lines that planning has laid out for the layer (adaptive and support cubic, lightning:
/// services/planning/algo/infill), cut to the region. Pitch and angle of the PatternContext are
/// ignored.
MakePattern PlannedLines;

}  // namespace slicefarm::infill
