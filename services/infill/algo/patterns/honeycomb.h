#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Hexagons of continuous rows. A row alternates between an upper and a lower flat part, connected
/// by slopes. Along each flat part, the neighbouring row has a flat part too: the two beads are
/// side by side, a spacing apart. The length s of a hexagon's side follows from the length of a
/// row's period: 2 s + 2 |slope| = 3 s * (sqrt 3 / 2) s / pitch. For beads without width this is s
/// = 8 / (3 sqrt 3) pitch.
MakePattern Honeycomb;

/// Hexagons with each edge printed once. The length of a hexagon's side is 2 / sqrt 3 pitch. Three
/// edges meet in each corner, so every corner is the end of a path.
MakePattern HoneycombCells;

}  // namespace slicefarm::infill
