#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

// Space-filling curves through square cells with a side of one pitch. The cells form a square
// around the origin with a fixed number of cells, large enough for any job. Each cell has one
// pitch of line, so the length per area is 1 / pitch. The region cuts the curves into pieces;
// links join the pieces later.

/// Hilbert's curve: each square is divided into four squares of half the size.
MakePattern Hilbert;
/// Peano's curve: each square is divided into nine squares of a third of the size.
MakePattern Peano;

}  // namespace slicefarm::infill
