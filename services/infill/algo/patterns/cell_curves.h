#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Space-filling curves through square cells with a side of one pitch. The cells form a square
/// around the origin. Its number of cells is fixed, and large enough for any job. Each cell has one
/// pitch of line, so that the length per area is 1 / pitch. A region cuts the curves into pieces;
/// links join the pieces.

/// Hilbert's curve: four squares of half the size at each step.
MakePattern Hilbert;
/// Peano's curve: nine squares of a third of the size at each step.
MakePattern Peano;

}  // namespace slicefarm::infill
