#pragma once

#include <functional>
#include <span>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// A closed line, and the step at which it was made: rings of one step are joined to each other
/// only where no ring of another step will do.
struct StepRing {
  Polygon points;
  int32_t step = 0;
};

/// Joins rings that lie `spacing_nm` apart to as few open paths as possible: to one, if every ring
/// lies within two spacings of another, and these form one family.
///
/// Two rings become one where they face each other: a piece as long as the spacing is cut out of
/// both, and their ends are linked across. That keeps the length, and lines at their spacing. If
/// all rings are of one step, which need not lie a spacing apart, the pieces are as long as the
/// rings are apart, where there is room for them. Links are made along a spanning tree of the
/// rings, steps in order. Where a ring was cut for its parent, its child's cut begins: so a chain
/// of nested rings becomes a double spiral, odd rings on the way in and even ones on the way out
/// (the connected Fermat spirals of Zhao et al., "Connected Fermat Spirals for Layered
/// Fabrication", SIGGRAPH 2016; with links square to the rings in place of theirs, which come
/// nearer than the spacing).
///
/// Each path starts and ends a spacing apart, at the first link of its first ring; a ring by itself
/// is closed (its last point is its first). Links cross nothing. Points are rounded to nm.
/// REQUIRES: rings are simple and do not cross. Cost: O(n log n) for n points and length / spacing,
/// where rings are cut often, more.
/// `may_link`: whether a link may run from one point to another, as far as other things than the
/// rings are in its way; it is asked for links less 20 nm at their ends. Empty: always.
std::vector<Polyline> LinkRings(std::span<const StepRing> rings, double spacing_nm,
                                const std::function<bool(Point, Point)>& may_link = {});

}  // namespace slicefarm::infill
