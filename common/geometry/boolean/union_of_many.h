#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

/// Returns Union(rings, FillRule::kNonZero) of many small rings that are side by side, such as the
/// faces of a surface seen from above. REQUIRES: the rings are counter-clockwise.
///
/// A sweep over all rings at once has a long list of the edges that its sweep line crosses. Its
/// time therefore grows with the square of the number of rings (200,000 faces: hours). This
/// function unites neighbouring rings first, then the unions, level by level. The result may differ
/// from Union's by 1 nm per level, and does not depend on the order of the rings. Returns an empty
/// region if `cancel` is triggered. Cost for n edges: O(n log n), if the outline of the result is
/// short compared with the outlines of the rings.
MultiPolygon UnionOfMany(std::vector<Polygon> rings, const CancelToken& cancel = {});

}  // namespace slicefarm
