#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Hexagons of continuous rows. A row steps up and down between flat parts, which it shares with
/// the neighbour rows: along them two beads are side by side, a spacing apart. The hexagon's side s
/// follows from the length of a period: 2 s + 2 |slope| = 3 s * (sqrt 3 / 2) s / pitch. For beads
/// without width this is s = 8 / (3 sqrt 3) pitch.
MakePattern Honeycomb;

/// Hexagons with each wall printed once: side 2 / sqrt 3 pitch. Three walls meet in each corner, so
/// that every corner is the end of a path.
MakePattern HoneycombCells;

}  // namespace slicefarm::infill
