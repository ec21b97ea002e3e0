#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

// Spirals around the object's origin. The loops of a spiral are a pitch apart.

/// Spiral r = pitch * number of loops, as straight segments.
MakePattern Archimedean;

/// Outline of two squares, rotated by 45 degrees against each other, that grows with each loop. All
/// sixteen edges of this star have the same distance from its middle, so the loops are a pitch
/// apart everywhere.
MakePattern Octagram;

}  // namespace slicefarm::infill
