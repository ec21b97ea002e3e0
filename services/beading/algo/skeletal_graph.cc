#include "services/beading/algo/skeletal_graph.h"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "services/beading/algo/voronoi_traits.h"

namespace slicefarm::beading {
namespace {

/// How far a node's distances to its features may differ.
constexpr double kRadiusErrorNm = 1'000;
/// How far a node may lie from the corner in which its edge is to end.
constexpr double kCornerErrorNm = 1'000;
/// Points on a curved edge that are nearer to each other than this are one.
constexpr double kLeastChordNm = 5'000;
constexpr int kMaxChords = 256;  ///< of one edge

using Diagram = boost::polygon::voronoi_diagram<double>;
using Edge = Diagram::edge_type;

Place Of(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// > 0 for a place to the left of the edge; its distance from the line, times the edge's length.
double Side(const BoundaryEdge& edge, Place p) {
  const Point d = edge.to - edge.from;
  return static_cast<double>(d.x) * (p.y - static_cast<double>(edge.from.y)) -
         static_cast<double>(d.y) * (p.x - static_cast<double>(edge.from.x));
}

/// What a cell of the diagram surrounds.
struct Feature {
  int edge = 0;
  bool is_corner = false;  ///< the one in which the edge starts
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
      for (Point* p : {&edge.from, &edge.to}) *p = {p->x * boundary.unit_nm, p->y * boundary.unit_nm};
  }

  bool Build() { return MakeCells() && MakeHalfEdges() && LinkRings() && HasRightShape(); }
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

  Place PlaceOf(const Diagram::vertex_type& vertex) const {
    return {vertex.x() * unit_, vertex.y() * unit_};
  }

  /// Whether the part of the diagram to the left of `edge` is the region's.
  bool IsInside(const Edge& edge) const {
    if (edge.is_secondary() || edge.is_infinite()) return false;
    const Place a = PlaceOf(*edge.vertex0()), b = PlaceOf(*edge.vertex1());
    const Place middle = {(a.x + b.x) / 2, (a.y + b.y) / 2};
    const Feature feature = FeatureOf(*edge.cell());
    const BoundaryEdge& after = graph_.boundary[feature.edge];
    if (!feature.is_corner) return Side(after, middle) > 0;
    if (!boundary_.StartsReflex(feature.edge)) return false;
    return Side(graph_.boundary[after.previous], middle) > 0 || Side(after, middle) > 0;
  }

  /// The diagram's edges within the region, for each feature in their order around it. False if
  /// those of a feature are not in one piece.
  bool MakeCells() {
    inside_.resize(diagram_.num_edges());
    for (const Edge& edge : diagram_.edges()) {
      const bool inside = IsInside(edge);
      inside_[IndexOf(edge)] = inside;
    }
    for (const Edge& edge : diagram_.edges())
      if (inside_[IndexOf(edge)] != inside_[IndexOf(*edge.twin())]) return false;
    const size_t count = boundary_.edges.size();
    edge_chain_.assign(count, {});
    corner_chain_.assign(count, {});
    for (const Diagram::cell_type& cell : diagram_.cells()) {
      if (cell.is_degenerate()) continue;
      const Feature feature = FeatureOf(cell);
      auto& chain = (feature.is_corner ? corner_chain_ : edge_chain_)[feature.edge];
      if (!CollectChain(cell, chain)) return false;
    }
    return true;
  }

  bool CollectChain(const Diagram::cell_type& cell, std::vector<const Edge*>& chain) {
    const Edge* const first = cell.incident_edge();
    size_t inside = 0;
    const Edge* start = nullptr;
    const Edge* edge = first;
    do {
      if (inside_[IndexOf(*edge)]) {
        ++inside;
        if (!inside_[IndexOf(*edge->prev())]) {
          if (start != nullptr) return false;
          start = edge;
        }
      }
      edge = edge->next();
    } while (edge != first);
    if (inside == 0) return true;
    if (start == nullptr) return false;
    for (edge = start; inside_[IndexOf(*edge)] && chain.size() < inside; edge = edge->next())
      chain.push_back(edge);
    return chain.size() == inside;
  }

  // --- nodes and half-edges ----------------------------------------------------------------------

  double DistanceTo(Feature feature, Place p) const {
    const BoundaryEdge& edge = graph_.boundary[feature.edge];
    if (feature.is_corner) return std::hypot(p.x - Of(edge.from).x, p.y - Of(edge.from).y);
    const Point d = edge.to - edge.from;
    const Place from = Of(edge.from), to = Of(edge.to);
    const double along = (p.x - from.x) * static_cast<double>(d.x) +
                         (p.y - from.y) * static_cast<double>(d.y);
    if (along <= 0) return std::hypot(p.x - from.x, p.y - from.y);
    if (along >= SquaredNorm(d)) return std::hypot(p.x - to.x, p.y - to.y);
    return std::abs(Side(edge, p)) / Norm(d);
  }

  /// The node of a vertex, or -1 if it is not as far from `a` as from `b` and all before them.
  int NodeOf(const Diagram::vertex_type& vertex, Feature a, Feature b) {
    const Place place = PlaceOf(vertex);
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
        between = AlongParabola(left.is_corner ? left : right, left.is_corner ? right : left, from,
                                to);
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

  /// Sorted parameters strictly between `from` and `to`: `marks` and steps between them of at most
  /// `step`; none nearer than kLeastChordNm to another one.
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

  /// Nodes as far from a corner as from an edge's line.
  std::vector<SkeletalNode> AlongParabola(Feature corner, Feature edge, int from, int to) const {
    const Place focus = Of(graph_.boundary[corner.edge].from);
    const BoundaryEdge& directrix = graph_.boundary[edge.edge];
    const Point d = directrix.to - directrix.from;
    const double length = Norm(d);
    const double ux = static_cast<double>(d.x) / length, uy = static_cast<double>(d.y) / length;
    const double height = Side(directrix, focus) / length;
    if (height < 1) return {};
    const auto along = [&](int node) {
      const Place p = graph_.nodes[node].place;
      return (p.x - focus.x) * ux + (p.y - focus.y) * uy;
    };
    const double mark = height * std::tan(options_.transition_angle / 2);
    std::vector<SkeletalNode> nodes;
    for (const double t :
         Parameters(along(from), along(to), {-mark, 0, mark}, StepFor(height))) {
      const double radius = (t * t + height * height) / (2 * height);
      const double rise = radius - height;
      nodes.push_back({{focus.x + t * ux - rise * uy, focus.y + t * uy + rise * ux}, radius});
    }
    return nodes;
  }

  /// Nodes as far from one corner as from the other.
  std::vector<SkeletalNode> BetweenCorners(Feature a, Feature b, int from, int to) const {
    const Place p = Of(graph_.boundary[a.edge].from), q = Of(graph_.boundary[b.edge].from);
    const double half = std::hypot(q.x - p.x, q.y - p.y) / 2;
    if (half < 1) return {};
    const Place middle = {(p.x + q.x) / 2, (p.y + q.y) / 2};
    const double ux = -(q.y - p.y) / (2 * half), uy = (q.x - p.x) / (2 * half);
    const auto along = [&](int node) {
      const Place at = graph_.nodes[node].place;
      return (at.x - middle.x) * ux + (at.y - middle.y) * uy;
    };
    const double mark = half * std::tan(options_.transition_angle / 2);
    std::vector<SkeletalNode> nodes;
    for (const double t : Parameters(along(from), along(to), {-mark, 0, mark}, StepFor(half)))
      nodes.push_back({{middle.x + t * ux, middle.y + t * uy}, std::hypot(t, half)});
    return nodes;
  }

  // --- rings -------------------------------------------------------------------------------------

  /// Chains of features after each other, against the direction of each ring.
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

  /// A convex corner's node becomes the corner itself.
  bool EndsInCorner(int last, int edge) {
    SkeletalNode& node = graph_.nodes[graph_.To(last)];
    const Place corner = Of(graph_.boundary[edge].from);
    if (!(std::hypot(node.place.x - corner.x, node.place.y - corner.y) <= kCornerErrorNm))
      return false;
    node = {corner, 0};
    return true;
  }

  /// Euler's formula for a connected graph with a cycle around each hole. Each half-edge is on the
  /// way around one ring already: next is a permutation.
  bool HasRightShape() const {
    const auto edges = static_cast<int>(graph_.half_edges.size() / 2);
    return edges - static_cast<int>(graph_.nodes.size()) + 1 == boundary_.Holes();
  }

  const Boundary& boundary_;
  const Diagram& diagram_;
  const SkeletalOptions& options_;
  const double unit_;
  SkeletalGraph graph_;
  std::vector<char> inside_;                            ///< by edge of the diagram
  std::vector<std::vector<const Edge*>> edge_chain_;    ///< by edge of the boundary
  std::vector<std::vector<const Edge*>> corner_chain_;  ///< by the edge that starts there
  std::vector<int> node_of_;                            ///< by vertex
  std::vector<int> first_half_, last_half_;             ///< by edge of the diagram
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
  const Place a = FromNode(half).place, b = ToNode(half).place;
  return std::hypot(b.x - a.x, b.y - a.y);
}

Place SkeletalGraph::Foot(int half, const SkeletalNode& node) const {
  const HalfEdge& edge = half_edges[half];
  const BoundaryEdge& feature = boundary[edge.feature];
  if (edge.is_corner) return Of(feature.from);
  const Point d = feature.to - feature.from;
  const Place from = Of(feature.from);
  const double along = (node.place.x - from.x) * static_cast<double>(d.x) +
                       (node.place.y - from.y) * static_cast<double>(d.y);
  const double t = std::clamp(along / SquaredNorm(d), 0.0, 1.0);
  return {from.x + t * static_cast<double>(d.x), from.y + t * static_cast<double>(d.y)};
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
  // In a corner of the boundary the way turns back at once.
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
  std::optional<SkeletalGraph> graph = BuildWith<UntrackedTraits>(boundary, options);
  if (graph) return graph;
  return BuildWith<boost::polygon::detail::voronoi_ctype_traits<int32_t>>(boundary, options);
}

}  // namespace slicefarm::beading
