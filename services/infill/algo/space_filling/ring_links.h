#pragma once

#include <functional>
#include <span>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Closed line and its step: its rank in the order of joining, for lines from RingsFrom the depth.
/// Rings of the same step are joined to each other only if no ring of another step is suitable.
struct StepRing {
  Polygon points;
  int32_t step = 0;
};

/// Joins rings that are `spacing_nm` apart into as few open paths as possible. The result is one
/// path if every ring is within two spacings of another, and all form one family.
///
/// Two rings are joined where they face each other: a piece as long as the spacing is cut out of
/// both, and their ends are linked. This keeps the length, and the spacing of the lines. If all
/// rings have the same step, they need not be a spacing apart. The pieces are then as long as the
/// distance between the rings, where there is enough length for them. Links are made along a
/// spanning tree of the rings, in the order of steps. The cut for a ring's child begins at the cut
/// for its parent. A chain of nested rings therefore becomes a double spiral, in which odd rings
/// lead inwards and even rings outwards. Source: Zhao et al., "Connected Fermat Spirals for Layered
/// Fabrication", SIGGRAPH 2016. Here the links are perpendicular to the rings; the original links
/// are nearer to the rings than the spacing.
///
/// The start and the end of each path are a spacing apart, at the first link of its first ring. A
/// single ring is closed (its last point is its first). Links cross no ring and no other link.
/// Points are rounded to nm. REQUIRES: rings are simple and do not cross. Cost: O(n log n) for n =
/// points + length / spacing; more if rings are cut often. `may_link` returns false if something
/// else than the rings blocks a link between two points. It is called for links shortened by 20 nm
/// at their ends. Empty: always true.
std::vector<Polyline> LinkRings(std::span<const StepRing> rings, double spacing_nm,
                                const std::function<bool(Point, Point)>& may_link = {});

}  // namespace slicefarm::infill
