#pragma once

#include <functional>
#include <span>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Closed line for LinkRings. Rings are joined in the order of `step`; for lines from RingsFrom
/// this is the depth in spacings. Rings of the same step are joined to each other only if no ring
/// of another step is suitable.
struct StepRing {
  Polygon points;
  int32_t step = 0;
};

/// Joins rings that are `spacing_nm` apart into as few open paths as possible. The result is one
/// path if all rings are connected by chains of rings that are at most two spacings apart.
///
/// Two rings are joined where they face each other: a piece as long as the spacing is cut out of
/// both, and the ends of the cuts are linked. This keeps the total length, and the spacing of the
/// lines. If all rings have the same step, they need not be a spacing apart. The cut pieces are
/// then as long as the distance between the two rings, if this fits. Links are made along a
/// spanning tree of the rings, in the order of steps. The cut for a ring's child in the tree begins
/// at the cut for its parent. A chain of nested rings therefore becomes a double spiral, in which
/// odd rings lead inwards and even rings outwards. Source: Zhao et al., "Connected Fermat Spirals
/// for Layered Fabrication", SIGGRAPH 2016. Here the links are perpendicular to the rings; the
/// original links are nearer to the rings than the spacing.
///
/// The start and the end of each path are a spacing apart, at the first link of its first ring. A
/// single ring is closed (its last point is its first). Links cross no ring and no other link.
/// Points are rounded to nm. `may_link`: returns false if an obstacle other than the rings blocks a
/// link between two points; it is called with links shortened by 20 nm at their ends. Empty: no
/// obstacles. REQUIRES: rings are simple and do not cross. Cost: O(n log n) for n = points + length
/// / spacing; more if rings are cut often.
std::vector<Polyline> LinkRings(std::span<const StepRing> rings, double spacing_nm,
                                const std::function<bool(Point, Point)>& may_link = {});

}  // namespace slicefarm::infill
