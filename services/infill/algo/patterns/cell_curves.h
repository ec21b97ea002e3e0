#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Space-filling curves through square cells with a side of one pitch. The square of cells is
/// around the origin, has a fixed number of cells, and contains any job. Each cell has one pitch of
/// line, so that the length per area is 1 / pitch. A region cuts the curves into pieces, which
/// links join.

/// Hilbert's curve: four squares of half the size at each step.
MakePattern Hilbert;
/// Peano's curve: nine squares of a third of the size at each step.
MakePattern Peano;

}  // namespace slicefarm::infill
