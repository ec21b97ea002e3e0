#pragma once

#include "absl/status/status.h"
#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// REQUEST_MALFORMED, with the place, if two edges cross or run along each other, in a ring or
/// between rings, or a ring is turned the wrong way. Touching is allowed. Exact.
/// Cost: O(n log n) where nothing touches, else O(n^2) at worst.
absl::Status CheckCrossings(const MultiPolygon& islands);

}  // namespace slicefarm::exposure
