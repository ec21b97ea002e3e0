#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Spirals around the object's origin with turns a pitch apart.

/// Spiral r = pitch * turns, in chords.
MakePattern Archimedean;

/// Outline of two squares, turned by 45 degrees against each other, that grows with each turn. All
/// sixteen edges of such a star have the same distance from its middle, so that turns are a pitch
/// apart everywhere.
MakePattern Octagram;

}  // namespace slicefarm::infill
