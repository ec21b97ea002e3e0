#include "common/geometry/skeleton/skeletal_graph.h"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "common/base/portable_math.h"
#include "common/geometry/skeleton/voronoi_traits.h"

namespace slicefarm {
namespace {

/// Maximum difference of a node's distances to its features.
constexpr double kRadiusErrorNm = 1'000;
/// Maximum distance of a node from the corner in which its edge should end.
constexpr double kCornerErrorNm = 20'000;
/// Distance below which two points on a curved edge are merged.
constexpr double kLeastChordNm = 5'000;
constexpr int kMaxChords = 256;  ///< maximum number of chords of one edge

using Diagram = boost::polygon::voronoi_diagram<double>;
using Edge = Diagram::edge_type;

/// Returns the distance of p from the line of the edge, times the edge's length. It is positive if
/// p is to the left of the edge.
double SideOf(const BoundaryEdge& edge, Vector2 p) {
  const Point d = edge.to - edge.from;
  return static_cast<double>(d.x) * (p.y() - static_cast<double>(edge.from.y)) -
         static_cast<double>(d.y) * (p.x() - static_cast<double>(edge.from.x));
}

/// The edge or corner of the boundary that a cell of the diagram belongs to.
struct Feature {
  int edge = 0;
  bool is_corner = false;  ///< true: the feature is the corner at the start of the edge
};

class Builder {
 public:
  Builder(const Boundary& boundary, const Diagram& diagram, const SkeletalOptions& options)
      : boundary_(boundary),
        diagram_(diagram),
        options_(options),
        unit_(static_cast<double>(boundary.unit_nm)),
        node_of_(diagram.num_vertices(), -1),
        first_half_(diagram.num_edges(), -1),
        last_half_(diagram.num_edges(), -1) {
    graph_.origin = boundary.origin;
    graph_.boundary = boundary.edges;
    for (BoundaryEdge& edge : graph_.boundary)
      for (Point* p : {&edge.from, &edge.to})
        *p = {p->x * boundary.unit_nm, p->y * boundary.unit_nm};
  }

  bool Build() {
    if (!MakeCells() || !MakeHalfEdges() || !LinkRings() || !HasRightShape()) return false;
    MergeCoincidentNodes();
    return true;
  }
  SkeletalGraph Take() { return std::move(graph_); }

 private:
  // --- cells -------------------------------------------------------------------------------------

  size_t IndexOf(const Edge& edge) const {
    return static_cast<size_t>(&edge - diagram_.edges().data());
  }

  Feature FeatureOf(const Diagram::cell_type& cell) const {
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
      const Feature feature = FeatureOf(cell);
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

  double DistanceTo(Feature feature, Vector2 p) const {
    const BoundaryEdge& edge = graph_.boundary[feature.edge];
    if (feature.is_corner)
      return Hypot(p.x() - ToVector(edge.from).x(), p.y() - ToVector(edge.from).y());
    const Point d = edge.to - edge.from;
    const Vector2 from = ToVector(edge.from), to = ToVector(edge.to);
    const double along = (p.x() - from.x()) * static_cast<double>(d.x) +
                         (p.y() - from.y()) * static_cast<double>(d.y);
    if (along <= 0) return Hypot(p.x() - from.x(), p.y() - from.y());
    if (along >= SquaredNorm(d)) return Hypot(p.x() - to.x(), p.y() - to.y());
    return std::abs(SideOf(edge, p)) / Norm(d);
  }

  /// Returns the node of a vertex. Returns -1 if the vertex has different distances to `a`, `b` and
  /// the earlier features.
  int NodeOf(const Diagram::vertex_type& vertex, Feature a, Feature b) {
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
      const Feature left = FeatureOf(*edge.cell()), right = FeatureOf(*edge.twin()->cell());
      const int from = NodeOf(*edge.vertex0(), left, right);
      const int to = NodeOf(*edge.vertex1(), left, right);
      if (from < 0 || to < 0) return false;
      std::vector<SkeletalNode> between;
      if (left.is_corner && right.is_corner) {
        between = BetweenCorners(left, right, from, to);
      } else if (left.is_corner || right.is_corner) {
        between =
            AlongParabola(left.is_corner ? left : right, left.is_corner ? right : left, from, to);
      }
      AddChords(edge, left, right, from, between, to);
    }
    return true;
  }

  void AddChords(const Edge& edge, Feature left, Feature right, int from,
                 const std::vector<SkeletalNode>& between, int to) {
    const int first = static_cast<int>(graph_.half_edges.size());
    int at = from;
    for (size_t i = 0; i <= between.size(); ++i) {
      const int next = i < between.size() ? AddNode(between[i]) : to;
      const int half = static_cast<int>(graph_.half_edges.size());
      graph_.half_edges.push_back({at, half + 2, half - 2, left.edge, left.is_corner});
      graph_.half_edges.push_back({next, half - 1, half + 3, right.edge, right.is_corner});
      at = next;
    }
    const int last = static_cast<int>(graph_.half_edges.size()) - 2;
    first_half_[IndexOf(edge)] = first;
    last_half_[IndexOf(edge)] = last;
    first_half_[IndexOf(*edge.twin())] = last ^ 1;
    last_half_[IndexOf(*edge.twin())] = first ^ 1;
  }

  // --- curves ------------------------------------------------------------------------------------

  /// Returns sorted parameters strictly between `from` and `to`: `marks`, and further parameters so
  /// that no step is longer than `step`. No two parameters are nearer to each other than
  /// kLeastChordNm.
  std::vector<double> Parameters(double from, double to, std::vector<double> marks,
                                 double step) const {
    const double low = std::min(from, to), high = std::max(from, to);
    std::erase_if(marks, [&](double m) { return m <= low || m >= high; });
    marks.push_back(high);
    std::sort(marks.begin(), marks.end());
    std::vector<double> parameters;
    double at = low;
    for (const double mark : marks) {
      const int pieces = std::clamp(static_cast<int>(std::ceil((mark - at) / step)), 1, kMaxChords);
      for (int i = 1; i <= pieces; ++i) {
        const double p = at + (mark - at) * i / pieces;
        const double before = parameters.empty() ? low : parameters.back();
        if (p - before >= kLeastChordNm && high - p >= kLeastChordNm) parameters.push_back(p);
      }
      at = mark;
    }
    if (from > to) std::reverse(parameters.begin(), parameters.end());
    return parameters;
  }

  double StepFor(double height) const {
    return std::min(options_.step_nm, std::sqrt(8 * std::max(height, 1.0) * options_.tolerance_nm));
  }

  /// Returns nodes with equal distances to a corner and to the line of an edge.
  std::vector<SkeletalNode> AlongParabola(Feature corner, Feature edge, int from, int to) const {
    const Vector2 focus = ToVector(graph_.boundary[corner.edge].from);
    const BoundaryEdge& directrix = graph_.boundary[edge.edge];
    const Point d = directrix.to - directrix.from;
    const double length = Norm(d);
    const double ux = static_cast<double>(d.x) / length, uy = static_cast<double>(d.y) / length;
    const double height = SideOf(directrix, focus) / length;
    if (height < 1) return {};
    const auto along = [&](int node) {
      const Vector2 p = graph_.nodes[node].place;
      return (p.x() - focus.x()) * ux + (p.y() - focus.y()) * uy;
    };
    const double mark = height * Tan(options_.transition_angle / 2);
    std::vector<SkeletalNode> nodes;
    for (const double t : Parameters(along(from), along(to), {-mark, 0, mark}, StepFor(height))) {
      const double radius = (t * t + height * height) / (2 * height);
      const double rise = radius - height;
      nodes.push_back({{focus.x() + t * ux - rise * uy, focus.y() + t * uy + rise * ux}, radius});
    }
    return nodes;
  }

  /// Returns nodes with equal distances to two corners.
  std::vector<SkeletalNode> BetweenCorners(Feature a, Feature b, int from, int to) const {
    const Vector2 p = ToVector(graph_.boundary[a.edge].from),
                  q = ToVector(graph_.boundary[b.edge].from);
    const double half = Hypot(q.x() - p.x(), q.y() - p.y()) / 2;
    if (half < 1) return {};
    const Vector2 middle = {(p.x() + q.x()) / 2, (p.y() + q.y()) / 2};
    const double ux = -(q.y() - p.y()) / (2 * half), uy = (q.x() - p.x()) / (2 * half);
    const auto along = [&](int node) {
      const Vector2 at = graph_.nodes[node].place;
      return (at.x() - middle.x()) * ux + (at.y() - middle.y()) * uy;
    };
    const double mark = half * Tan(options_.transition_angle / 2);
    // The radius becomes straighter with the distance from the centre. Even steps of u in t = half
    // sinh(u) therefore have an error of at most half u^2 / 8.
    const auto stretched = [&](double t) { return half * Asinh(t / half); };
    std::vector<SkeletalNode> nodes;
    for (const double u : Parameters(stretched(along(from)), stretched(along(to)),
                                     {-stretched(mark), 0, stretched(mark)}, StepFor(half))) {
      const double t = half * Sinh(u / half);
      nodes.push_back({{middle.x() + t * ux, middle.y() + t * uy}, Hypot(t, half)});
    }
    return nodes;
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
      int last = last_half_[IndexOf(*edge_chain_[edge].back())];
      if (reflex) {
        if (!Join(last, first_half_[IndexOf(*corner_chain_[edge].front())])) return false;
        last = last_half_[IndexOf(*corner_chain_[edge].back())];
      } else if (!EndsInCorner(last, edge)) {
        return false;
      }
      const int previous = boundary_.edges[edge].previous;
      if (!Join(last, first_half_[IndexOf(*edge_chain_[previous].front())])) return false;
    }
    return true;
  }

  void LinkChain(const std::vector<const Edge*>& chain) {
    for (size_t i = 0; i + 1 < chain.size(); ++i)
      Link(last_half_[IndexOf(*chain[i])], first_half_[IndexOf(*chain[i + 1])]);
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
    const Vector2 corner = ToVector(graph_.boundary[edge].from);
    if (!(Hypot(node.place.x() - corner.x(), node.place.y() - corner.y()) <= kCornerErrorNm))
      return false;
    node = {corner, 0};
    return true;
  }

  /// Checks Euler's formula for a connected graph with a cycle around each hole. Each half-edge is
  /// already on the walk of exactly one ring, because `next` is a permutation.
  bool HasRightShape() const {
    const auto edges = static_cast<int>(graph_.half_edges.size() / 2);
    return edges - static_cast<int>(graph_.nodes.size()) + 1 == boundary_.Holes();
  }

  // --- coincident nodes --------------------------------------------------------------------------

  /// Merges nodes at the same position. Such nodes appear where more than three sides have equal
  /// distances. Their radii differ by rounding, so that one of them would be a local maximum.
  void MergeCoincidentNodes() {
    constexpr double kCoincidentNm = 100;
    std::vector<int> same(graph_.nodes.size());
    std::iota(same.begin(), same.end(), 0);
    const auto find = [&](int node) {
      while (same[node] != node) node = same[node] = same[same[node]];
      return node;
    };
    std::vector<char> gone(graph_.half_edges.size() / 2);
    for (int half = 0; half < static_cast<int>(graph_.half_edges.size()); half += 2) {
      if (graph_.Length(half) > kCoincidentNm) continue;
      const int a = find(graph_.half_edges[half].from), b = find(graph_.To(half));
      const bool at_corner = graph_.nodes[a].radius == 0 || graph_.nodes[b].radius == 0;
      if (a == b || at_corner) continue;
      same[std::max(a, b)] = std::min(a, b);
      gone[half / 2] = true;
      for (const int dropped : {half, half ^ 1})
        Link(graph_.half_edges[dropped].previous, graph_.half_edges[dropped].next);
    }
    for (HalfEdge& edge : graph_.half_edges) edge.from = find(edge.from);
    Compact(gone);
  }

  void Compact(const std::vector<char>& gone) {
    std::vector<int> half_now(graph_.half_edges.size(), -1), node_now(graph_.nodes.size(), -1);
    SkeletalGraph kept{graph_.origin, {}, {}, std::move(graph_.boundary)};
    for (size_t half = 0; half < half_now.size(); ++half) {
      if (gone[half / 2]) continue;
      half_now[half] = static_cast<int>(kept.half_edges.size());
      kept.half_edges.push_back(graph_.half_edges[half]);
    }
    for (HalfEdge& edge : kept.half_edges) {
      edge.next = half_now[edge.next];
      edge.previous = half_now[edge.previous];
      int& node = node_now[edge.from];
      if (node < 0) {
        node = static_cast<int>(kept.nodes.size());
        kept.nodes.push_back(graph_.nodes[edge.from]);
      }
      edge.from = node;
    }
    graph_ = std::move(kept);
  }

  const Boundary& boundary_;
  const Diagram& diagram_;
  const SkeletalOptions& options_;
  const double unit_;
  SkeletalGraph graph_;
  std::vector<char> inside_;                            ///< one per edge of the diagram
  std::vector<std::vector<const Edge*>> edge_chain_;    ///< one per edge of the boundary
  std::vector<std::vector<const Edge*>> corner_chain_;  ///< one per edge that starts in the corner
  std::vector<int> node_of_;                            ///< one per vertex
  std::vector<int> first_half_, last_half_;             ///< one per edge of the diagram
};

template <typename Traits>
std::optional<SkeletalGraph> BuildWith(const Boundary& boundary, const SkeletalOptions& options) {
  boost::polygon::voronoi_builder<int32_t, Traits> voronoi;
  for (const BoundaryEdge& edge : boundary.edges) {
    voronoi.insert_segment(static_cast<int32_t>(edge.from.x), static_cast<int32_t>(edge.from.y),
                           static_cast<int32_t>(edge.to.x), static_cast<int32_t>(edge.to.y));
  }
  Diagram diagram;
  voronoi.construct(&diagram);
  Builder builder(boundary, diagram, options);
  if (!builder.Build()) return std::nullopt;
  return builder.Take();
}

}  // namespace

double SkeletalGraph::Length(int half) const {
  const Vector2 a = FromNode(half).place, b = ToNode(half).place;
  return Hypot(b.x() - a.x(), b.y() - a.y());
}

Vector2 SkeletalGraph::Foot(int half, const SkeletalNode& node) const {
  const HalfEdge& edge = half_edges[half];
  const BoundaryEdge& feature = boundary[edge.feature];
  if (edge.is_corner) return ToVector(feature.from);
  const Point d = feature.to - feature.from;
  const Vector2 from = ToVector(feature.from);
  const double along = (node.place.x() - from.x()) * static_cast<double>(d.x) +
                       (node.place.y() - from.y()) * static_cast<double>(d.y);
  const double t = std::clamp(along / SquaredNorm(d), 0.0, 1.0);
  return {from.x() + t * static_cast<double>(d.x), from.y() + t * static_cast<double>(d.y)};
}

std::vector<int> SkeletalGraph::Leaving() const {
  std::vector<int> leaving(nodes.size(), -1);
  for (int half = static_cast<int>(half_edges.size()) - 1; half >= 0; --half)
    leaving[half_edges[half].from] = half;
  return leaving;
}

int SkeletalGraph::Split(int half, const SkeletalNode& node) {
  const int middle = static_cast<int>(nodes.size());
  nodes.push_back(node);
  const int twin = half ^ 1;
  const int onward = static_cast<int>(half_edges.size()), back = onward + 1;
  half_edges.push_back(half_edges[half]);
  half_edges.push_back(half_edges[twin]);
  const auto link = [this](int from, int to) {
    half_edges[from].next = to;
    half_edges[to].previous = from;
  };
  // In a corner of the boundary, the walk reverses its direction.
  const bool turns = half_edges[half].next == twin;
  link(onward, turns ? back : half_edges[half].next);
  if (!turns) link(half_edges[twin].previous, back);
  link(half, onward);
  link(back, twin);
  half_edges[onward].from = half_edges[twin].from = middle;
  return onward;
}

std::optional<SkeletalGraph> MakeSkeletalGraph(const Boundary& boundary,
                                               const SkeletalOptions& options) {
  std::optional<SkeletalGraph> graph = BuildWith<LooseTraits>(boundary, options);
  if (graph) return graph;
  return BuildWith<boost::polygon::detail::voronoi_ctype_traits<int32_t>>(boundary, options);
}

}  // namespace slicefarm
