#pragma once

#include <array>
#include <cstdint>

#include "common/model/options/cutter.h"
#include "services/milling/algo/push/edge_push.h"

namespace slicefarm::milling {

/// Contact of the cutter with the inside of a triangle. A triangle has at most one. The
/// cutter is then on the side to which the triangle falls.
struct FacetContact {
  /// 1: the contact is the high end of the interval; -1: the low end; 0: no contact
  int8_t side = 0;
  double end = 0;
  FiberPoint at;
};

/// Upward normal of a triangle, with length 1, for fibers of one direction. Its coordinates do not
/// depend on the fiber.
struct FacetNormal {
  double along = 0;
  double across = 0;
  double up = 0;
  /// length of the normal's horizontal part; 0: a level triangle, or one without area
  double flat = 0;
};

/// Returns the normal of a triangle.
FacetNormal NormalOf(const std::array<FiberPoint, 3>& corners);

/// Returns the contact with the inside of a triangle. A plane of a given slope touches the cutter
/// at one height above the tip (Cutter::TouchHeight). At this height the triangle has a level line,
/// and the contact is on this line. Seen from above, the cutter's axis is downhill of the contact.
/// Level and vertical triangles are touched only by their edges. Cost: 15 ns.
FacetContact PushFacet(const Cutter& cutter, const std::array<FiberPoint, 3>& corners,
                       const FacetNormal& normal);

}  // namespace slicefarm::milling
