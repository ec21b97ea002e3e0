#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Spirals around the object's origin whose turns lie a pitch apart.

/// r = pitch * turns, by chords.
MakePattern Archimedean;

/// The outline of two squares turned against each other by 45 degrees, growing as it goes round.
/// All sixteen edges of such a star lie equally far from its middle, so that turns are a pitch
/// apart everywhere.
MakePattern Octagram;

}  // namespace slicefarm::infill
