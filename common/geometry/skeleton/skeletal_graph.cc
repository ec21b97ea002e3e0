#include "common/geometry/skeleton/skeletal_graph.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/base/portable_math.h"
#include "common/geometry/skeleton/axis_tracer.h"
#include "common/geometry/skeleton/chords.h"
#include "common/geometry/skeleton/voronoi_axis.h"

namespace slicefarm {
namespace {

/// Returns true if the graph is an axis of the region. The walks around the rings must meet each
/// feature of the boundary once and in order. The graph must have as many cycles as the region has
/// holes. It is planar then, like the region.
bool FollowsBoundary(const SkeletalGraph& graph, const Boundary& boundary) {
  const size_t count = boundary.edges.size();
  std::vector<char> met(2 * count);
  size_t features = count;
  for (size_t edge = 0; edge < count; ++edge)
    features += boundary.StartsReflex(static_cast<int>(edge));
  const auto feature_of = [&](int half) {
    return BoundaryFeature{graph.half_edges[half].feature, graph.half_edges[half].is_corner};
  };
  for (int half = 0; half < static_cast<int>(graph.half_edges.size()); ++half) {
    const int next = graph.half_edges[half].next;
    if (next < 0 || graph.half_edges[next].from != graph.To(half)) return false;
    const BoundaryFeature feature = feature_of(half), after = feature_of(next);
    if (after == feature) continue;
    if (after != boundary.Before(feature)) return false;
    char& is_met = met[2 * feature.edge + feature.is_corner];
    if (is_met) return false;
    is_met = 1;
    --features;
  }
  const auto edges = static_cast<int>(graph.half_edges.size() / 2);
  return features == 0 && edges - static_cast<int>(graph.nodes.size()) + 1 == boundary.Holes();
}

/// Merges nodes at the same position.
class NodeMerger {
 public:
  explicit NodeMerger(SkeletalGraph graph) : graph_(std::move(graph)) {}

  /// Merges nodes at the same position. Such nodes appear where more than three sides have equal
  /// distances. Their radii differ by rounding, so that one of them would be a local maximum.
  void Merge() {
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

  SkeletalGraph Take() { return std::move(graph_); }

 private:
  void Link(int half, int next) {
    graph_.half_edges[half].next = next;
    graph_.half_edges[next].previous = half;
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

  SkeletalGraph graph_;
};

std::optional<SkeletalGraph> MakeAxis(const Boundary& boundary) {
  for (const auto& make : {TraceAxis, VoronoiAxis, ExactVoronoiAxis}) {
    std::optional<SkeletalGraph> axis = make(boundary);
    if (axis && FollowsBoundary(*axis, boundary)) return axis;
  }
  return std::nullopt;
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
  std::optional<SkeletalGraph> axis = MakeAxis(boundary);
  if (!axis) return std::nullopt;
  axis->origin = boundary.origin;
  axis->boundary = boundary.EdgesInNm();
  NodeMerger merger(WithChords(*std::move(axis), options));
  merger.Merge();
  return merger.Take();
}

}  // namespace slicefarm
