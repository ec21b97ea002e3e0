#pragma once

#include <optional>
#include <span>

#include "common/base/cancel_token.h"
#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"
#include "common/model/options/hole_options.h"

namespace slicefarm::slicing {

/// Circle of a vertical hole.
struct HoleCircle {
  Point center;
  double radius_nm = 0;
};

/// Returns the circle of a hole, or nullopt if the hole is not round: it has at most 8 corners, is
/// not convex, or its corners or the middles of its edges have distances from the centre that
/// differ by the threshold or more.
std::optional<HoleCircle> CircleOf(const Polygon& hole, const PolyholeOptions& options);

/// Returns the polygon that replaces a hole in a layer. Its edges touch the circle, so that the
/// circle fits into it. The number of edges is four per nozzle diameter of the radius at a nozzle
/// of 0.4 mm, at least 3. Twisted polygons of five consecutive layers turn by a fifth of an edge
/// each. Source: nophead, "Polyholes", 2011.
Polygon Polyhole(const HoleCircle& circle, const PolyholeOptions& options, int32_t layer);

/// Replaces the round holes of one object by polyholes: holes that continue in the same place with
/// the same size in the next layer, and holes of the lowest layer. `sections`: one per layer,
/// bottom up. If `cancel` is set, none or only some of the sections are changed. Cost: O(points),
/// and for each hole O(holes of the next layer).
void MakePolyholes(const PolyholeOptions& options, std::span<ObjectSection* const> sections,
                   const CancelToken& cancel = {});

}  // namespace slicefarm::slicing
