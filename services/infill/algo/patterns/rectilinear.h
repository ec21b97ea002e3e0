#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Parallel lines, a pitch apart. Rectilinear lines turn by a right angle from layer to layer;
/// aligned ones do not. The length per area is exactly 1 / pitch.
MakePattern Rectilinear;
MakePattern AlignedRectilinear;

}  // namespace slicefarm::infill
