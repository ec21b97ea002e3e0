#pragma once

#include "services/infill/algo/patterns/pattern.h"

namespace slicefarm::infill {

/// Loops along the region's boundary, a pitch apart. The first loop is PatternContext::first_line
/// pitches inside the boundary, normally half a pitch. Each loop fills a strip of half a pitch on
/// either side. The length per area is therefore 1 / pitch, except at corners and in the middle,
/// where strips meet. The loops follow the region and do not depend on the origin.
MakePattern Concentric;

}  // namespace slicefarm::infill
