#pragma once

#include <optional>
#include <vector>

#include "common/geometry/skeleton/boundary.h"
#include "common/geometry/vector.h"

namespace slicefarm {

/// A node of the medial axis. Corners of the boundary are also nodes (radius 0).
struct SkeletalNode {
  Vector2 place = Vector2::Zero();
  double radius = 0;  ///< distance to the boundary, in nm
};

/// One of the two directions of an edge of the medial axis; the opposite direction has the index
/// `index ^ 1`. To the left of the half-edge is the part of the region that is nearest to
/// `feature`. A feature is an edge of the boundary, or the reflex corner at the start of an edge.
struct HalfEdge {
  int from = 0;  ///< start node
  /// Next half-edge of the walk around a ring of the boundary, against the ring's direction.
  int next = 0;
  int previous = 0;
  int feature = 0;
  bool is_corner = false;
};

/// The medial axis of a region, with a closed walk along its half-edges for each ring of the
/// boundary. Together with the foot of each node (the nearest point on the boundary), these are the
/// ribs and quads of a skeletal trapezoidation.
///
/// The walk follows HalfEdge::next. It visits the features of the ring (HalfEdge::feature) one
/// after the other, against the ring's direction, and of each feature all half-edges. Each
/// half-edge begins in the node where the one before it ends. Every half-edge is on the walk of
/// exactly one ring. Source: T. Kuipers et al. 2020, section 3.1. Unlike there, no nodes are stored
/// for the feet; Foot() computes these points.
struct SkeletalGraph {
  Point origin;
  std::vector<SkeletalNode> nodes;
  std::vector<HalfEdge> half_edges;
  std::vector<BoundaryEdge> boundary;  ///< in nm from `origin`

  /// Returns the end node of a half-edge.
  int To(int half) const { return half_edges[half ^ 1].from; }
  const SkeletalNode& FromNode(int half) const { return nodes[half_edges[half].from]; }
  const SkeletalNode& ToNode(int half) const { return nodes[To(half)]; }
  /// Returns the length of a half-edge, in nm.
  double Length(int half) const;
  /// Returns the point nearest to the node on the half-edge's feature.
  Vector2 Foot(int half, const SkeletalNode& node) const;
  /// Returns the index of one half-edge that starts at each node, indexed by node.
  std::vector<int> Leaving() const;
  /// Calls visit(half) for each half-edge that has the same start node as `leaving`, in their order
  /// around this node.
  template <typename Visit>
  void ForEachLeaving(int leaving, const Visit& visit) const {
    int half = leaving;
    do {
      visit(half);
      half = half_edges[half].previous ^ 1;
    } while (half != leaving);
  }
  /// Inserts a node into an edge: `half` and its twin now end and begin at the node. Returns the
  /// new half-edge that starts at the node, in the direction of `half`.
  int Split(int half, const SkeletalNode& node);
};

/// Precision of the chords that replace curved edges (parabolas) of the medial axis.
struct SkeletalOptions {
  double tolerance_nm = 2'000;  ///< largest error of a chord, in position and in radius
  double step_nm = 800'000;     ///< upper limit on the length of a chord
  /// An edge is central if the two boundary sides beside it form an angle below this one, in
  /// radians. A chord ends at the point of a curve where the angle has this value.
  double transition_angle = 0.1745;
};

/// Returns the skeletal graph of the region of `boundary`, or nothing if its axis is unreliable.
/// The axis is traced (axis_tracer.h). If tracing gives up, it is made from the Voronoi diagram
/// (voronoi_axis.h). An axis is reliable under two conditions, which are checked:
/// - The walks around the rings meet all features in order.
/// - The graph has as many cycles as the region has holes, so it is planar like the region.
///
/// Cost: O(n log n) for n edges: about 1.5 us per edge.
std::optional<SkeletalGraph> MakeSkeletalGraph(const Boundary& boundary,
                                               const SkeletalOptions& options);

}  // namespace slicefarm
