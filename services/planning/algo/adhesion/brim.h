#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "common/model/options/adhesion_options.h"

namespace slicefarm::planning {

/// Offset that closes gaps between adjacent regions; rounding leaves such gaps.
constexpr Coord kGlueNm = 500;

/// One object on the plate, as input of BrimRegions.
struct BrimObject {
  /// outlines of the object's first layer, after elephant foot compensation
  MultiPolygon outlines;
  BrimOptions options;
};

/// Returns the brim regions of the objects: one per object, all disjoint.
///
/// An object's brim is the area at a distance between separation and separation + width from its
/// outlines. By BrimType it is outside the outer rings, in the holes, or both. An island inside a
/// hole of the same object counts as inside, so kOuterOnly gives this island no brim. Another
/// object inside the hole is treated like any other object.
/// - No brim is closer to an object than the separation of this object, whether the object has a
///   brim or not.
/// - A piece of a brim without contact with its own object is left out. An example is a piece in
///   the hole of a neighbouring part.
/// - Where brims overlap, the object that is first in `objects` gets the area. This may cut off
///   pieces thinner than half a line from the other object's brim. The first object gets these
///   pieces too.
/// - All other pieces thinner than half a line are left out.
/// - No brim leaves `bed`. An empty `bed` is no limit.
///
/// Shapes: objects may touch or overlap. Units: nm, in plate coordinates. Distances are exact to
/// 0.008 mm and joins are round. A negative width or separation counts as 0. Errors: Cancelled,
/// polled once per object. Cost: O(n log n) for n points of an object and its neighbours. Source:
/// measured with PrusaSlicer 2.5.0: a box, a frame, and a frame with a pin in it.
/// - The brim starts at brim_separation from the compensated outline. It has floor(width / spacing)
///   lines, and the outermost line is printed first.
/// - outer_only gives a pin in the frame's hole no brim. inner_only and outer_and_inner give the
///   pin its ring.
/// - An object with a raft gets no brim.
/// - Different in slicefarm: the region has exactly the requested width.
absl::StatusOr<std::vector<MultiPolygon>> BrimRegions(std::span<const BrimObject> objects,
                                                      const MultiPolygon& bed,
                                                      const CancelToken& cancel = {});

}  // namespace slicefarm::planning
