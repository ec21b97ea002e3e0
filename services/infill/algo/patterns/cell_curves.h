#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Space-filling curves through square cells of a pitch, in a square of a fixed number of cells
/// around the origin that holds any job. Each cell has one pitch of line, so length per area is
/// 1 / pitch. Cut by a region they fall into pieces, which links join.

/// Four squares of half the size at each step.
MakePattern Hilbert;
/// Nine squares of a third.
MakePattern Peano;

}  // namespace slicefarm::infill
