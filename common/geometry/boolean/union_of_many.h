#pragma once

#include <vector>

#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

/// Returns Union(rings, FillRule::kNonZero) of many small rings that lie side by side, such as the
/// faces of a surface seen from above. REQUIRES: the rings run counter-clockwise.
///
/// A sweep over all rings at once keeps a list of all edges at its height, and so takes a time that
/// grows with the square of their number (200,000 faces: hours). This unites neighbours first, then
/// their unions, level by level. The result may differ from Union's by 1 nm a level and does not
/// depend on the order of the rings. Empty once `cancel` says so. Cost: O(n log n) while the
/// outline of the whole is short beside those of the rings.
MultiPolygon UnionOfMany(std::vector<Polygon> rings, const CancelToken& cancel = {});

}  // namespace slicefarm
