#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "common/model/options/adhesion_options.h"

namespace slicefarm::planning {

/// Closes the cracks that rounding leaves between regions with a common border.
constexpr Coord kGlueNm = 500;

/// One object on the plate.
struct BrimObject {
  MultiPolygon outlines;  ///< what its first layer prints, elephant foot compensation applied
  BrimOptions options;
};

/// The regions that the objects' brims cover, one for each object, disjoint.
///
/// An object's brim is what lies farther than its separation, and no farther than separation +
/// width, from its outlines: on the outside of its outer rings, in its holes, or both. What stands
/// in a hole of the same object counts as inside: kOuterOnly gives it none. Another object that
/// stands there is an object like any other.
/// - No brim comes closer to any object than that object's separation (its brim or no brim).
/// - A piece that lost its own object, such as in the hole of a part beside it, is left out.
/// - Where brims overlap, the object that comes first in `objects` has the place; the seam between
///   two leaves no piece thinner than half a line, the first one takes that too.
/// - What is thinner than half a line is left out.
/// - Nothing lies outside of `bed`; an empty one is no limit.
///
/// Shapes: objects may touch or overlap. Units: nm, in plate coordinates; distances are exact to
/// 0.008 mm, joins round. Negative width or separation count as 0.
/// Errors: Cancelled, polled once an object.
/// Cost: O(n log n) an object and its neighbours.
/// Source: measured, PrusaSlicer 2.5.0, box, frame, and frame with a pin in it: the brim starts at
/// brim_separation from the compensated outline, floor(width / spacing) lines, the outermost
/// printed first; outer_only gives a pin in the frame's hole nothing, inner_only and
/// outer_and_inner give it its ring; no brim with a raft. Here the region is as wide as asked.
absl::StatusOr<std::vector<MultiPolygon>> BrimRegions(std::span<const BrimObject> objects,
                                                      const MultiPolygon& bed,
                                                      const CancelToken& cancel = {});

}  // namespace slicefarm::planning
