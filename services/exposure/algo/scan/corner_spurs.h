#pragma once

#include "services/exposure/algo/scan/convex_ring.h"

namespace slicefarm::exposure {

struct SpurFill {
  double spot_nm = 0;
  double least_nm = 0;  ///< shorter spurs are left out
};

/// A ring that reaches into the corners of the gap around it, which a round spot leaves open: from
/// a corner out along its bisector, until the spot touches the gap's tip, and back. Where the tip
/// is narrower than a quarter of the spot it stays open: a spur would melt more twice than once.
///
/// ring, around: convex, counter-clockwise; `around` is the gap's outer border, and has the ring
/// inside. Cost: O(n), and O(n) for each spur.
ConvexRing WithSpurs(const ConvexRing& ring, const ConvexRing& around, const SpurFill& fill);

}  // namespace slicefarm::exposure
