#include "services/beading/algo/skeleton/skeleton.h"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "common/base/portable_math.h"
#include "common/geometry/predicates.h"
#include "services/beading/algo/skeleton/boundary.h"
#include "services/beading/algo/skeleton/voronoi_traits.h"

namespace slicefarm::beading {
namespace {

/// Nodes nearer than this are one: far below what a printer resolves.
constexpr double kMergeNm = 1'000;
/// How far a node's distances to its sources may differ before the diagram is called wrong.
constexpr double kRadiusErrorNm = 1'000;
constexpr int kMaxChords = 64;  ///< of one parabola

using Diagram = boost::polygon::voronoi_diagram<double>;

double Side(Point a, Point b, double x, double y) {
  return static_cast<double>(b.x - a.x) * (y - static_cast<double>(a.y)) -
         static_cast<double>(b.y - a.y) * (x - static_cast<double>(a.x));
}

double DistanceTo(Point p, double x, double y) {
  return Hypot(x - static_cast<double>(p.x), y - static_cast<double>(p.y));
}

double DistanceTo(const BoundaryEdge& edge, double x, double y) {
  const Point d = edge.to - edge.from;
  const double px = x - static_cast<double>(edge.from.x), py = y - static_cast<double>(edge.from.y);
  const double along = px * static_cast<double>(d.x) + py * static_cast<double>(d.y);
  if (along <= 0) return DistanceTo(edge.from, x, y);
  if (along >= SquaredNorm(d)) return DistanceTo(edge.to, x, y);
  return std::abs(Side(edge.from, edge.to, x, y)) / Norm(d);
}

/// What a cell of the diagram surrounds: a boundary edge, or the point at which one starts.
struct Source {
  bool is_point = false;
  int edge = 0;
};

int Root(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Collects the inner edges of a diagram as a skeleton.
class SkeletonBuilder {
 public:
  SkeletonBuilder(const std::vector<BoundaryEdge>& boundary, const Diagram& diagram,
                  double tolerance, double radius_error)
      : boundary_(boundary),
        diagram_(diagram),
        tolerance_(tolerance),
        radius_error_(radius_error),
        node_of_(diagram.num_vertices(), -1) {}

  /// False if the diagram is wrong: nodes are not where they should be, or edges are missing or too
  /// many.
  bool Build(int holes) {
    for (const Diagram::edge_type& edge : diagram_.edges()) {
      if (edge.is_secondary() || edge.is_infinite() || &edge > edge.twin()) continue;
      const Source a = SourceOf(*edge.cell()), b = SourceOf(*edge.twin()->cell());
      if (!IsInside(a, edge) || !IsInside(b, edge)) continue;
      if (!AddEdge(a, b, edge)) return false;
    }
    return HasRightShape(holes);
  }

  std::vector<SkeletonNode> TakeNodes() { return std::move(nodes_); }
  std::vector<SkeletonEdge> TakeEdges() { return std::move(edges_); }

 private:
  Source SourceOf(const Diagram::cell_type& cell) const {
    const int edge = static_cast<int>(cell.source_index());
    if (!cell.contains_point()) return {false, edge};
    const bool starts =
        cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
    return {true, starts ? edge : boundary_[edge].next};
  }

  double DistanceToSource(const Source& source, double x, double y) const {
    const BoundaryEdge& edge = boundary_[source.edge];
    return source.is_point ? DistanceTo(edge.from, x, y) : DistanceTo(edge, x, y);
  }

  /// Whether the part of the diagram next to `source` that `edge` bounds lies in the region.
  bool IsInside(const Source& source, const Diagram::edge_type& edge) const {
    const double x = (edge.vertex0()->x() + edge.vertex1()->x()) / 2;
    const double y = (edge.vertex0()->y() + edge.vertex1()->y()) / 2;
    const BoundaryEdge& after = boundary_[source.edge];
    if (!source.is_point) return Side(after.from, after.to, x, y) > 0;
    const BoundaryEdge& before = boundary_[after.previous];
    // Only reflex corners have a cell of their own inside: what is left of one of the two edges.
    if (Orientation(before.from, before.to, after.to) >= 0) return false;
    return Side(before.from, before.to, x, y) > 0 || Side(after.from, after.to, x, y) > 0;
  }

  /// The node of a vertex, or -1 if its distances to the two sources do not agree.
  int NodeOf(const Diagram::vertex_type& vertex, const Source& a, const Source& b) {
    const double radius = DistanceToSource(a, vertex.x(), vertex.y());
    const double other = DistanceToSource(b, vertex.x(), vertex.y());
    if (!(std::abs(radius - other) <= radius_error_)) return -1;
    int& node = node_of_[static_cast<size_t>(&vertex - diagram_.vertices().data())];
    if (node < 0) {
      node = static_cast<int>(nodes_.size());
      nodes_.push_back({vertex.x(), vertex.y(), (radius + other) / 2});
    }
    return node;
  }

  bool AddEdge(const Source& a, const Source& b, const Diagram::edge_type& edge) {
    const int first = NodeOf(*edge.vertex0(), a, b), last = NodeOf(*edge.vertex1(), a, b);
    if (first < 0 || last < 0) return false;
    if (edge.is_linear()) {
      edges_.push_back({first, last});
    } else if (a.is_point != b.is_point) {
      AddParabola(boundary_[(a.is_point ? a : b).edge].from, boundary_[(a.is_point ? b : a).edge],
                  first, last);
    } else {
      return false;
    }
    return true;
  }

  /// Chords along the points that are as far from `focus` as from `directrix`, between two nodes on
  /// it.
  void AddParabola(Point focus, const BoundaryEdge& directrix, int first, int last) {
    const Point d = directrix.to - directrix.from;
    const double length = Norm(d);
    const double ux = static_cast<double>(d.x) / length, uy = static_cast<double>(d.y) / length;
    const auto along = [&](double x, double y) {
      return (x - static_cast<double>(focus.x)) * ux + (y - static_cast<double>(focus.y)) * uy;
    };
    const double height = Side(directrix.from, directrix.to, static_cast<double>(focus.x),
                               static_cast<double>(focus.y)) /
                          length;
    const double from = along(nodes_[first].x, nodes_[first].y);
    const double to = along(nodes_[last].x, nodes_[last].y);
    int previous = first;
    const int chords = ChordCount(std::abs(height), std::abs(to - from));
    for (int i = 1; i < chords; ++i) {
      const double t = from + (to - from) * i / chords;
      const double rise = (t * t + height * height) / (2 * height) - height;
      nodes_.push_back({static_cast<double>(focus.x) + t * ux - rise * uy,
                        static_cast<double>(focus.y) + t * uy + rise * ux,
                        std::abs(rise + height)});
      const int node = static_cast<int>(nodes_.size()) - 1;
      edges_.push_back({previous, node});
      previous = node;
    }
    edges_.push_back({previous, last});
  }

  /// A chord over a width t of the parabola with focal height h misses it by t^2 / 8h at most.
  int ChordCount(double height, double width) const {
    if (height < 1) return 1;
    const double chords = width / std::sqrt(8 * height * tolerance_);
    return std::clamp(static_cast<int>(std::ceil(std::min<double>(chords, kMaxChords))), 1,
                      kMaxChords);
  }

  /// The medial axis of a region is connected, has one cycle around each hole, and ends in each
  /// convex corner and nowhere else.
  bool HasRightShape(int holes) const {
    const auto nodes = static_cast<int>(nodes_.size()), edges = static_cast<int>(edges_.size());
    if (edges - nodes + 1 != holes) return false;
    std::vector<int> degree(nodes_.size(), 0), parent(nodes_.size());
    std::iota(parent.begin(), parent.end(), 0);
    int parts = nodes;
    for (const SkeletonEdge& edge : edges_) {
      ++degree[edge.a], ++degree[edge.b];
      const int a = Root(parent, edge.a), b = Root(parent, edge.b);
      if (a != b) parent[a] = b, --parts;
    }
    int corners = 0;
    for (const BoundaryEdge& edge : boundary_)
      corners += Orientation(boundary_[edge.previous].from, edge.from, edge.to) > 0;
    return parts == 1 && std::count(degree.begin(), degree.end(), 1) == corners;
  }

  const std::vector<BoundaryEdge>& boundary_;
  const Diagram& diagram_;
  const double tolerance_;
  const double radius_error_;
  std::vector<int> node_of_;
  std::vector<SkeletonNode> nodes_;
  std::vector<SkeletonEdge> edges_;
};

/// False if the diagram is wrong.
template <typename Traits>
bool BuildWith(const Boundary& boundary, Coord tolerance_nm, Skeleton& skeleton) {
  boost::polygon::voronoi_builder<int32_t, Traits> voronoi;
  for (const BoundaryEdge& edge : boundary.edges) {
    voronoi.insert_segment(static_cast<int32_t>(edge.from.x), static_cast<int32_t>(edge.from.y),
                           static_cast<int32_t>(edge.to.x), static_cast<int32_t>(edge.to.y));
  }
  Diagram diagram;
  voronoi.construct(&diagram);
  const auto unit = static_cast<double>(boundary.unit_nm);
  SkeletonBuilder builder(boundary.edges, diagram, static_cast<double>(tolerance_nm) / unit,
                          kRadiusErrorNm / unit);
  if (!builder.Build(boundary.Holes())) return false;
  skeleton.nodes = builder.TakeNodes();
  skeleton.edges = builder.TakeEdges();
  for (SkeletonNode& node : skeleton.nodes)
    node = {node.x * unit, node.y * unit, node.radius * unit};
  return true;
}

/// Makes one of nodes that are joined by an edge shorter than kMergeNm.
void MergeShortEdges(Skeleton& skeleton) {
  std::vector<int> parent(skeleton.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (const SkeletonEdge& edge : skeleton.edges) {
    const SkeletonNode &a = skeleton.nodes[edge.a], &b = skeleton.nodes[edge.b];
    if (Hypot(a.x - b.x, a.y - b.y) >= kMergeNm) continue;
    const int i = Root(parent, edge.a), j = Root(parent, edge.b);
    parent[std::max(i, j)] = std::min(i, j);
  }
  std::vector<SkeletonEdge> kept;
  kept.reserve(skeleton.edges.size());
  for (const SkeletonEdge& edge : skeleton.edges) {
    const SkeletonEdge merged{Root(parent, edge.a), Root(parent, edge.b)};
    if (merged.a != merged.b) kept.push_back(merged);
  }
  skeleton.edges = std::move(kept);
}

}  // namespace

Skeleton MakeSkeleton(const PolygonWithHoles& region, Coord tolerance_nm) {
  const std::optional<Boundary> boundary = MakeBoundary(region);
  Skeleton skeleton;
  if (!boundary) return skeleton;
  skeleton.origin = boundary->origin;
  if (!BuildWith<LooseTraits>(*boundary, tolerance_nm, skeleton) &&
      !BuildWith<boost::polygon::detail::voronoi_ctype_traits<int32_t>>(*boundary, tolerance_nm,
                                                                        skeleton)) {
    return {};
  }
  MergeShortEdges(skeleton);
  return skeleton;
}

}  // namespace slicefarm::beading
