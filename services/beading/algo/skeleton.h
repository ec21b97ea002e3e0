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
/// touch (the diagram's precondition; checked exactly), regions wider than 2.1 m (it takes 32-bit
/// integers), and nodes whose distances to the places they claim to lie between differ.
///
/// Cost: O(n log n), n points: about 20 us each.
/// Source: Boost.Polygon's Voronoi diagram of segments.
Skeleton MakeSkeleton(const PolygonWithHoles& region, Coord tolerance_nm);

}  // namespace slicefarm::beading
