#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Loops along the region's edge: the first half a pitch inside, then one a pitch. Law: each loop
/// stands for a strip half a pitch to either side, so length per area is 1 / pitch but for corners
/// and the middle, where strips meet. Not tied to the origin: loops follow the region.
MakePattern Concentric;

}  // namespace slicefarm::infill
