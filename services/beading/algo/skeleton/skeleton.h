#pragma once

#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// A point that is equally far from two or more places of the boundary.
struct SkeletonNode {
  double x = 0;  ///< nm, relative to Skeleton::origin
  double y = 0;
  double radius = 0;  ///< nm, distance to the boundary
};

struct SkeletonEdge {
  int a = 0;  ///< nodes
  int b = 0;
};

/// The medial axis of a region as a graph of straight edges. No edge is shorter than kMergeNm but
/// for cycles.
struct Skeleton {
  Point origin;
  std::vector<SkeletonNode> nodes;
  std::vector<SkeletonEdge> edges;
};

/// The medial axis of `region`: the edges of the Voronoi diagram of its boundary's segments that
/// lie inside, without those that only part a segment from its own end. Parabolas become chords
/// within `tolerance_nm`.
///
/// The result is empty, rather than wrong, where the diagram cannot be trusted: rings that cross or
/// touch (the diagram's precondition; checked exactly), and diagrams that fail their checks. What
/// is checked: nodes are as far from the places they claim to lie between; the axis is connected,
/// has a cycle around each hole, and ends in each convex corner and nowhere else. A first try in
/// plain doubles passes nearly always, a second one in exact arithmetic gets the rest.
///
/// Cost: O(n log n), n points: about 3 us each, 20 us if the second try is needed.
/// Source: Boost.Polygon's Voronoi diagram of segments.
Skeleton MakeSkeleton(const PolygonWithHoles& region, Coord tolerance_nm);

}  // namespace slicefarm::beading
