#include "common/geometry/skeleton/voronoi_axis.h"

#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/skeleton/voronoi_traits.h"

namespace slicefarm {
namespace {

/// Maximum difference of a node's distances to its features.
constexpr double kRadiusErrorNm = 1'000;
/// Maximum distance of a node from the corner in which its edge should end.
constexpr double kCornerErrorNm = 20'000;

using Diagram = boost::polygon::voronoi_diagram<double>;
using Edge = Diagram::edge_type;

class Builder {
 public:
  Builder(const Boundary& boundary, const Diagram& diagram)
      : boundary_(boundary),
        edges_(boundary.EdgesInNm()),
        diagram_(diagram),
        unit_(static_cast<double>(boundary.unit_nm)),
        node_of_(diagram.num_vertices(), -1),
        half_of_(diagram.num_edges(), -1) {}

  bool Build() { return MakeCells() && MakeHalfEdges() && LinkRings(); }
  SkeletalGraph Take() { return std::move(graph_); }

 private:
  // --- cells -------------------------------------------------------------------------------------

  size_t IndexOf(const Edge& edge) const {
    return static_cast<size_t>(&edge - diagram_.edges().data());
  }

  BoundaryFeature FeatureOf(const Diagram::cell_type& cell) const {
    const int edge = static_cast<int>(cell.source_index());
    if (!cell.contains_point()) return {edge, false};
    const bool starts =
        cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
    return {starts ? edge : boundary_.edges[edge].next, true};
  }

  Vector2 PlaceOf(const Diagram::vertex_type& vertex) const {
    return {vertex.x() * unit_, vertex.y() * unit_};
  }

  /// Collects the edges of the diagram that are within the region, for each feature in their order
  /// around the feature. The function follows the connections of the cells; the positions of the
  /// edges are less exact.
  bool MakeCells() {
    inside_.assign(diagram_.num_edges(), false);
    const size_t count = boundary_.edges.size();
    edge_chain_.assign(count, {});
    corner_chain_.assign(count, {});
    for (const Diagram::cell_type& cell : diagram_.cells()) {
      if (cell.is_degenerate()) continue;
      const BoundaryFeature feature = FeatureOf(cell);
      if (feature.is_corner && !boundary_.StartsReflex(feature.edge)) continue;
      auto& chain = (feature.is_corner ? corner_chain_ : edge_chain_)[feature.edge];
      const bool found = feature.is_corner ? CollectAroundCorner(cell, chain)
                                           : CollectBeside(cell, feature.edge, chain);
      if (!found) return false;
      for (const Edge* edge : chain) inside_[IndexOf(*edge)] = true;
    }
    for (const Edge& edge : diagram_.edges())
      if (inside_[IndexOf(edge)] != inside_[IndexOf(*edge.twin())]) return false;
    return true;
  }

  /// Collects the edges around a reflex corner. The cell of the corner is bounded by two secondary
  /// edges that meet in the corner; all remaining edges are the chain.
  static bool CollectAroundCorner(const Diagram::cell_type& cell, std::vector<const Edge*>& chain) {
    const Edge* start = nullptr;
    const Edge* edge = cell.incident_edge();
    do {
      if (edge->is_secondary() && !edge->next()->is_secondary()) {
        if (start != nullptr) return false;
        start = edge->next();
      }
      edge = edge->next();
    } while (edge != cell.incident_edge());
    if (start == nullptr) return false;
    for (edge = start; !edge->is_secondary(); edge = edge->next()) {
      if (edge->is_infinite()) return false;
      chain.push_back(edge);
    }
    return true;
  }

  /// Collects the edges beside an edge of the boundary. The cell surrounds this edge; the chain
  /// runs from the end of the edge to its start. Each end is at the one secondary edge between this
  /// cell and the cell of the corner. This secondary edge is within the region at a reflex corner,
  /// and on the other side of the boundary at a convex corner.
  bool CollectBeside(const Diagram::cell_type& cell, int index, std::vector<const Edge*>& chain) {
    const int next = boundary_.edges[index].next;
    const Edge* at_end = nullptr;
    const Edge* at_start = nullptr;
    const Edge* edge = cell.incident_edge();
    do {
      const Diagram::cell_type& beside = *edge->twin()->cell();
      if (edge->is_secondary() && beside.contains_point()) {
        const int corner = FeatureOf(beside).edge;
        if (corner == next) at_end = edge;
        if (corner == index) at_start = edge;
      }
      edge = edge->next();
    } while (edge != cell.incident_edge());
    if (at_end == nullptr || at_start == nullptr) return false;
    const Edge* const start = boundary_.StartsReflex(next) ? at_end : at_end->next();
    const Edge* const end = boundary_.StartsReflex(index) ? at_start->next() : at_start;
    for (edge = start; edge != end; edge = edge->next()) {
      if (edge->is_infinite()) return false;
      if (!edge->is_secondary()) chain.push_back(edge);
    }
    return true;
  }

  // --- nodes and half-edges ----------------------------------------------------------------------

  double DistanceTo(BoundaryFeature feature, Vector2 p) const {
    const BoundaryEdge& edge = edges_[feature.edge];
    if (feature.is_corner)
      return Hypot(p.x() - ToVector(edge.from).x(), p.y() - ToVector(edge.from).y());
    const Point d = edge.to - edge.from;
    const Vector2 from = ToVector(edge.from), to = ToVector(edge.to);
    const double along = (p.x() - from.x()) * static_cast<double>(d.x) +
                         (p.y() - from.y()) * static_cast<double>(d.y);
    if (along <= 0) return Hypot(p.x() - from.x(), p.y() - from.y());
    if (along >= SquaredNorm(d)) return Hypot(p.x() - to.x(), p.y() - to.y());
    return std::abs(edge.SideOf(p)) / Norm(d);
  }

  /// Returns the node of a vertex. Returns -1 if the vertex has different distances to `a`, `b` and
  /// the earlier features.
  int NodeOf(const Diagram::vertex_type& vertex, BoundaryFeature a, BoundaryFeature b) {
    const Vector2 place = PlaceOf(vertex);
    const double to_a = DistanceTo(a, place), to_b = DistanceTo(b, place);
    if (!(std::abs(to_a - to_b) <= kRadiusErrorNm)) return -1;
    int& node = node_of_[static_cast<size_t>(&vertex - diagram_.vertices().data())];
    if (node < 0) {
      node = AddNode({place, (to_a + to_b) / 2});
    } else if (!(std::abs(graph_.nodes[node].radius - to_a) <= 2 * kRadiusErrorNm)) {
      return -1;
    }
    return node;
  }

  int AddNode(const SkeletalNode& node) {
    graph_.nodes.push_back(node);
    return static_cast<int>(graph_.nodes.size()) - 1;
  }

  bool MakeHalfEdges() {
    for (const Edge& edge : diagram_.edges()) {
      if (!inside_[IndexOf(edge)] || &edge > edge.twin()) continue;
      const BoundaryFeature left = FeatureOf(*edge.cell()), right = FeatureOf(*edge.twin()->cell());
      const int from = NodeOf(*edge.vertex0(), left, right);
      const int to = NodeOf(*edge.vertex1(), left, right);
      if (from < 0 || to < 0) return false;
      AddEdge(edge, left, right, from, to);
    }
    return true;
  }

  void AddEdge(const Edge& edge, BoundaryFeature left, BoundaryFeature right, int from, int to) {
    const int half = static_cast<int>(graph_.half_edges.size());
    graph_.half_edges.push_back({from, -1, -1, left.edge, left.is_corner});
    graph_.half_edges.push_back({to, -1, -1, right.edge, right.is_corner});
    half_of_[IndexOf(edge)] = half;
    half_of_[IndexOf(*edge.twin())] = half ^ 1;
  }

  // --- rings -------------------------------------------------------------------------------------

  /// Links the chains of consecutive features, against the direction of each ring.
  bool LinkRings() {
    const int count = static_cast<int>(boundary_.edges.size());
    for (int edge = 0; edge < count; ++edge) {
      if (edge_chain_[edge].empty()) return false;
      const bool reflex = boundary_.StartsReflex(edge);
      if (reflex == corner_chain_[edge].empty()) return false;
      LinkChain(edge_chain_[edge]);
      LinkChain(corner_chain_[edge]);
      int last = half_of_[IndexOf(*edge_chain_[edge].back())];
      if (reflex) {
        if (!Join(last, half_of_[IndexOf(*corner_chain_[edge].front())])) return false;
        last = half_of_[IndexOf(*corner_chain_[edge].back())];
      } else if (!EndsInCorner(last, edge)) {
        return false;
      }
      const int previous = boundary_.edges[edge].previous;
      if (!Join(last, half_of_[IndexOf(*edge_chain_[previous].front())])) return false;
    }
    return true;
  }

  void LinkChain(const std::vector<const Edge*>& chain) {
    for (size_t i = 0; i + 1 < chain.size(); ++i)
      Link(half_of_[IndexOf(*chain[i])], half_of_[IndexOf(*chain[i + 1])]);
  }

  void Link(int half, int next) {
    graph_.half_edges[half].next = next;
    graph_.half_edges[next].previous = half;
  }

  bool Join(int last, int first) {
    Link(last, first);
    return graph_.To(last) == graph_.half_edges[first].from;
  }

  /// Moves the node at a convex corner to the corner itself. Returns false if the node is too far
  /// from it.
  bool EndsInCorner(int last, int edge) {
    SkeletalNode& node = graph_.nodes[graph_.To(last)];
    const Vector2 corner = ToVector(edges_[edge].from);
    if (!(Hypot(node.place.x() - corner.x(), node.place.y() - corner.y()) <= kCornerErrorNm))
      return false;
    node = {corner, 0};
    return true;
  }

  const Boundary& boundary_;
  const std::vector<BoundaryEdge> edges_;  ///< in nm
  const Diagram& diagram_;
  const double unit_;
  SkeletalGraph graph_;
  std::vector<char> inside_;                            ///< one per edge of the diagram
  std::vector<std::vector<const Edge*>> edge_chain_;    ///< one per edge of the boundary
  std::vector<std::vector<const Edge*>> corner_chain_;  ///< one per edge that starts in the corner
  std::vector<int> node_of_;                            ///< one per vertex
  std::vector<int> half_of_;                            ///< one per edge of the diagram
};

template <typename Traits>
std::optional<SkeletalGraph> AxisBy(const Boundary& boundary) {
  boost::polygon::voronoi_builder<int32_t, Traits> voronoi;
  for (const BoundaryEdge& edge : boundary.edges) {
    voronoi.insert_segment(static_cast<int32_t>(edge.from.x), static_cast<int32_t>(edge.from.y),
                           static_cast<int32_t>(edge.to.x), static_cast<int32_t>(edge.to.y));
  }
  Diagram diagram;
  voronoi.construct(&diagram);
  Builder builder(boundary, diagram);
  if (!builder.Build()) return std::nullopt;
  return builder.Take();
}

}  // namespace

std::optional<SkeletalGraph> VoronoiAxis(const Boundary& boundary) {
  return AxisBy<LooseTraits>(boundary);
}

std::optional<SkeletalGraph> ExactVoronoiAxis(const Boundary& boundary) {
  return AxisBy<boost::polygon::detail::voronoi_ctype_traits<int32_t>>(boundary);
}

}  // namespace slicefarm
