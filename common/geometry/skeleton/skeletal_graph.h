#pragma once

#include <optional>
#include <vector>

#include "common/geometry/skeleton/boundary.h"
#include "common/geometry/vector.h"

namespace slicefarm {

/// A node of the medial axis, corners of the boundary (radius 0) included.
struct SkeletalNode {
  Vector2 place = Vector2::Zero();
  double radius = 0;  ///< nm, distance to the boundary
};

/// One of the two directions of an edge of the medial axis; the other one is `index ^ 1`. To its
/// left lies the part of the region that is nearest to `feature`: an edge of the boundary, or the
/// reflex corner in which one starts.
struct HalfEdge {
  int from = 0;  ///< node
  int next = 0;  ///< around the ring of the boundary, against its direction
  int previous = 0;
  int feature = 0;
  bool is_corner = false;
};

/// The medial axis of a region, and around each ring of the boundary the way along its edges: with
/// the foot of each node on the boundary these are the ribs and quads of a skeletal trapezoidation.
///
/// Walking `next`, half-edges of one feature follow each other, then those of the feature before it
/// on the ring; where one ends the next one begins, in the same node. Every half-edge is on one
/// ring's way.
/// Source: T. Kuipers et al. 2020, section 3.1; as arrays, without nodes for the ribs' feet.
struct SkeletalGraph {
  Point origin;
  std::vector<SkeletalNode> nodes;
  std::vector<HalfEdge> half_edges;
  std::vector<BoundaryEdge> boundary;  ///< in nm from `origin`

  int To(int half) const { return half_edges[half ^ 1].from; }
  const SkeletalNode& FromNode(int half) const { return nodes[half_edges[half].from]; }
  const SkeletalNode& ToNode(int half) const { return nodes[To(half)]; }
  double Length(int half) const;
  /// The nearest point of the half-edge's feature.
  Vector2 Foot(int half, const SkeletalNode& node) const;
  /// By node: a half-edge that leaves it.
  std::vector<int> Leaving() const;
  /// Calls visit(half) for each half-edge that leaves the node that `leaving` leaves, around it.
  template <typename Visit>
  void ForEachLeaving(int leaving, const Visit& visit) const {
    int half = leaving;
    do {
      visit(half);
      half = half_edges[half].previous ^ 1;
    } while (half != leaving);
  }
  /// Puts a node into an edge: `half` and its twin end and begin there from now on. Returns the new
  /// half-edge that goes on from the node in `half`'s direction.
  int Split(int half, const SkeletalNode& node);
};

struct SkeletalOptions {
  double tolerance_nm = 2'000;  ///< of parabolas and their radii, where chords take their place
  double step_nm = 800'000;     ///< the longest chord
  double transition_angle = 0.1745;  ///< radians: chords end where centrality changes
};

/// The graph of `boundary`'s region; nothing where the diagram cannot be trusted. What is checked:
/// every node is as far from all features around it; the ways around the rings close, with all
/// features in their order; and the graph has as many cycles as the region has holes, hence is
/// planar as the region is. Each try is another way to compute the diagram.
///
/// Cost: O(n log n), n edges: about 5 us each.
/// Source: Boost.Polygon's Voronoi diagram of segments.
std::optional<SkeletalGraph> MakeSkeletalGraph(const Boundary& boundary,
                                               const SkeletalOptions& options);

}  // namespace slicefarm
