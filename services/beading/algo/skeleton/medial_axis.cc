#include "services/beading/algo/skeleton/medial_axis.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>

#include "common/base/portable_math.h"
#include "common/geometry/skeleton/skeletal_graph.h"

namespace slicefarm::beading {
namespace {

/// Distance below which nodes are merged; it is far below the resolution of a printer.
constexpr double kMergeNm = 1'000;
/// Sides that meet at a smaller angle face each other. It is 80 degrees, so that a square corner is
/// a corner and not a tip.
constexpr double kFacingAngle = 1.389;
/// Sine of half of kFacingAngle: the change of the radius per length along the axis.
constexpr double kFacing = 0.64;
/// Length below which a branch is removed, in radii of the node where it starts. Such a short
/// branch covers no area that other lines do not cover.
constexpr double kShortBranch = 1.0;
/// Distance between the end of a line and the middle of the line that it meets, in radii.
constexpr double kRetreat = 0.8;
/// Extension of a line beyond the last node of its axis, in radii of this node. The circle around
/// the node touches the end of the region.
constexpr double kExtend = 0.25;
/// Smallest length of a line, in radii of its widest point. Rounder regions give a dot of this
/// length.
constexpr double kLeastLength = 0.8;

struct AxisEdge {
  int a = 0;  ///< node at one end
  int b = 0;
};

int Root(std::vector<int>& parent, int i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

/// Returns the edges of a graph between nodes that are not merged.
std::vector<AxisEdge> MergedEdges(const SkeletalGraph& graph) {
  std::vector<int> parent(graph.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  const int halves = static_cast<int>(graph.half_edges.size());
  for (int half = 0; half < halves; half += 2) {
    if (graph.Length(half) >= kMergeNm) continue;
    const int i = Root(parent, graph.half_edges[half].from), j = Root(parent, graph.To(half));
    parent[std::max(i, j)] = std::min(i, j);
  }
  std::vector<AxisEdge> edges;
  for (int half = 0; half < halves; half += 2) {
    const AxisEdge edge{Root(parent, graph.half_edges[half].from), Root(parent, graph.To(half))};
    if (edge.a != edge.b) edges.push_back(edge);
  }
  return edges;
}

/// Remaining edges of a medial axis and their connections.
class AxisGraph {
 public:
  AxisGraph(const SkeletalGraph& graph, double min_radius)
      : origin_(graph.origin), nodes_(graph.nodes), edges_(MergedEdges(graph)) {
    CutAt(min_radius);
    alive_.assign(edges_.size(), true);
    BuildIncidence();
  }

  const SkeletalNode& Node(int i) const { return nodes_[i]; }
  Point PointOf(int i) const {
    return origin_ + Point{std::llround(Node(i).place.x()), std::llround(Node(i).place.y())};
  }
  int NodeCount() const { return static_cast<int>(nodes_.size()); }
  int Degree(int node) const { return degree_[node]; }

  /// Returns the node with the largest radius among the nodes with an edge; -1 if there is none.
  int Widest() const {
    int widest = -1;
    for (int i = 0; i < NodeCount(); ++i)
      if (degree_[i] > 0 && (widest < 0 || Node(i).radius > Node(widest).radius)) widest = i;
    return widest;
  }

  /// Removes edges that lead into blunt corners, beginning at the leaves.
  void TrimCorners() {
    std::vector<int> leaves = Leaves();
    while (!leaves.empty()) {
      const int leaf = leaves.back();
      leaves.pop_back();
      if (degree_[leaf] != 1) continue;
      const int edge = FirstEdge(leaf);
      if (IsFacing(edge)) continue;
      const int other = OtherEnd(edge, leaf);
      Remove(edge);
      if (degree_[other] == 1) leaves.push_back(other);
    }
  }

  /// Removes branches that end within the circle of the fork where they start, the shortest first
  /// (for equal lengths, the first leaf). The path along a branch is followed only once: if its
  /// fork disappears, the search continues from there. Cost: O(n log n).
  void PruneShortBranches() {
    branches_.assign(nodes_.size(), {});
    branch_at_edge_.assign(edges_.size(), -1);
    for (const int leaf : Leaves()) {
      branches_[leaf].at = leaf;
      WalkOn(leaf, FirstEdge(leaf));
    }
    while (!short_branches_.empty()) {
      const auto [reach, leaf] = short_branches_.top();
      short_branches_.pop();
      // Otherwise the branch was removed or extended since it was queued.
      if (degree_[leaf] != 1 || branches_[leaf].reach != reach || !IsShort(leaf)) continue;
      const int fork = branches_[leaf].at;
      RemoveBranch(leaf);
      if (degree_[fork] == 2) JoinBranchesAt(fork);
    }
  }

  /// Returns lines of nodes. At a fork, the two edges with the smallest bend form one line. A
  /// closed line repeats its first node.
  std::vector<std::vector<int>> Lines() {
    PairAtForks();
    std::vector<std::vector<int>> lines;
    std::vector<bool> used(edges_.size(), false);
    for (int pass = 0; pass < 2; ++pass) {  // open lines from their ends first, then rings
      for (size_t e = 0; e < edges_.size(); ++e) {
        if (!alive_[e] || used[e]) continue;
        const AxisEdge& edge = edges_[e];
        if (pass == 1 || Continuation(static_cast<int>(e), edge.a) < 0) {
          lines.push_back(Follow(static_cast<int>(e), edge.a, used));
        } else if (Continuation(static_cast<int>(e), edge.b) < 0) {
          lines.push_back(Follow(static_cast<int>(e), edge.b, used));
        }
      }
    }
    return lines;
  }

 private:
  double Apart(int a, int b) const {
    const Vector2 p = Node(a).place, q = Node(b).place;
    return Hypot(p.x() - q.x(), p.y() - q.y());
  }
  double EdgeLength(int e) const { return Apart(edges_[e].a, edges_[e].b); }
  bool IsFacing(int e) const {
    const AxisEdge& edge = edges_[e];
    return std::abs(Node(edge.a).radius - Node(edge.b).radius) < kFacing * EdgeLength(e);
  }
  int OtherEnd(int e, int node) const { return edges_[e].a == node ? edges_[e].b : edges_[e].a; }

  /// Removes the parts thinner than `min_radius`. Edges that cross this radius end there.
  void CutAt(double min_radius) {
    std::vector<AxisEdge> kept;
    kept.reserve(edges_.size());
    for (AxisEdge edge : edges_) {
      if (Node(edge.a).radius > Node(edge.b).radius) std::swap(edge.a, edge.b);
      const SkeletalNode thin = Node(edge.a), thick = Node(edge.b);
      if (thick.radius <= min_radius) continue;
      if (thin.radius < min_radius) {
        const double t = (min_radius - thin.radius) / (thick.radius - thin.radius);
        edge.a = NodeCount();
        nodes_.push_back({{std::lerp(thin.place.x(), thick.place.x(), t),
                           std::lerp(thin.place.y(), thick.place.y(), t)},
                          min_radius});
      }
      kept.push_back(edge);
    }
    edges_ = std::move(kept);
  }

  void BuildIncidence() {
    degree_.assign(nodes_.size(), 0);
    for (const AxisEdge& edge : edges_) ++degree_[edge.a], ++degree_[edge.b];
    first_.assign(nodes_.size() + 1, 0);
    std::partial_sum(degree_.begin(), degree_.end(), first_.begin() + 1);
    incident_.resize(edges_.size() * 2);
    std::vector<int> at(first_.begin(), first_.end() - 1);
    for (size_t e = 0; e < edges_.size(); ++e) {
      incident_[at[edges_[e].a]++] = static_cast<int>(e);
      incident_[at[edges_[e].b]++] = static_cast<int>(e);
    }
  }

  std::vector<int> Leaves() const {
    std::vector<int> leaves;
    for (int i = 0; i < NodeCount(); ++i)
      if (degree_[i] == 1) leaves.push_back(i);
    return leaves;
  }

  /// Returns the first edge of a node; for a leaf, it is the only one.
  int FirstEdge(int node) const {
    for (int i = first_[node]; i < first_[node + 1]; ++i)
      if (alive_[incident_[i]]) return incident_[i];
    return -1;
  }
  int NextEdge(int node, int from_edge) const {
    for (int i = first_[node]; i < first_[node + 1]; ++i)
      if (alive_[incident_[i]] && incident_[i] != from_edge) return incident_[i];
    return -1;
  }
  void Remove(int e) {
    alive_[e] = false;
    --degree_[edges_[e].a];
    --degree_[edges_[e].b];
  }

  /// Extends the branch of `leaf` over `edge` to the next fork, and queues it there if it is short.
  void WalkOn(int leaf, int edge) {
    Branch& branch = branches_[leaf];
    for (; edge >= 0; edge = NextEdge(branch.at, edge)) {
      branch.reach += EdgeLength(edge);
      branch.at = OtherEnd(edge, branch.at);
      if (degree_[branch.at] <= 2) continue;
      branch_at_edge_[edge] = leaf;
      if (IsShort(leaf)) short_branches_.push({branch.reach, leaf});
      return;
    }
  }

  /// REQUIRES: the branch ends at a node that is, or was, a fork.
  bool IsShort(int leaf) const {
    const Branch& branch = branches_[leaf];
    return degree_[branch.at] > 2 && branch.reach <= kShortBranch * Node(branch.at).radius;
  }

  /// Extends the branches that ended at this node over its other edge, because the node is no fork
  /// any more.
  void JoinBranchesAt(int node) {
    const int one = FirstEdge(node), other = NextEdge(node, one);
    const int leaf = branch_at_edge_[one], other_leaf = branch_at_edge_[other];
    if (leaf >= 0 && branches_[leaf].at == node) WalkOn(leaf, other);
    if (other_leaf >= 0 && branches_[other_leaf].at == node) WalkOn(other_leaf, one);
  }

  void RemoveBranch(int leaf) {
    int node = leaf;
    while (degree_[node] == 1) {
      const int edge = FirstEdge(node);
      node = OtherEnd(edge, node);
      Remove(edge);
      if (degree_[node] >= 2) return;
    }
  }

  /// Pairs the edges at each node: at forks, the two edges with the smallest bend continue each
  /// other.
  void PairAtForks() {
    pair_.assign(nodes_.size(), {-1, -1});
    for (int node = 0; node < NodeCount(); ++node) {
      if (degree_[node] < 2) continue;
      double straightest = 2;
      for (int i = first_[node]; i < first_[node + 1]; ++i) {
        if (!alive_[incident_[i]]) continue;
        for (int j = i + 1; j < first_[node + 1]; ++j) {
          if (!alive_[incident_[j]]) continue;
          const double bend = CosBetween(node, incident_[i], incident_[j]);
          if (bend < straightest) straightest = bend, pair_[node] = {incident_[i], incident_[j]};
        }
      }
    }
  }

  double CosBetween(int node, int e, int f) const {
    const Vector2 o = Node(node).place, p = Node(OtherEnd(e, node)).place,
                  q = Node(OtherEnd(f, node)).place;
    const double px = p.x() - o.x(), py = p.y() - o.y(), qx = q.x() - o.x(), qy = q.y() - o.y();
    return (px * qx + py * qy) / (Hypot(px, py) * Hypot(qx, qy));
  }

  int Continuation(int e, int node) const {
    if (pair_[node].first == e) return pair_[node].second;
    if (pair_[node].second == e) return pair_[node].first;
    return -1;
  }

  std::vector<int> Follow(int e, int from, std::vector<bool>& used) const {
    std::vector<int> nodes = {from};
    while (e >= 0 && !used[e]) {
      used[e] = true;
      nodes.push_back(OtherEnd(e, nodes.back()));
      e = Continuation(e, nodes.back());
    }
    return nodes;
  }

  /// Path from a leaf to the next fork.
  struct Branch {
    int at = 0;  ///< fork at its end, or another leaf
    double reach = 0;
  };
  using Queued = std::pair<double, int>;  ///< reach and leaf

  Point origin_;
  std::vector<SkeletalNode> nodes_;
  std::vector<AxisEdge> edges_;
  std::vector<bool> alive_;
  std::vector<int> degree_;
  std::vector<int> first_;     ///< first index of each node in incident_
  std::vector<int> incident_;  ///< edges of the nodes, node after node
  std::vector<std::pair<int, int>> pair_;
  std::vector<Branch> branches_;
  /// Leaf of the branch that has this edge as its last one before its fork.
  std::vector<int> branch_at_edge_;
  std::priority_queue<Queued, std::vector<Queued>, std::greater<>> short_branches_;
};

/// Kind of the end of a line in the graph.
enum class End { kTip, kBlunt, kFork };

End EndAt(const AxisGraph& graph, int node, double min_radius) {
  if (graph.Degree(node) > 2) return End::kFork;
  return graph.Node(node).radius > 1.05 * min_radius ? End::kBlunt : End::kTip;
}

void FinishEnd(ThickLine& line, End end, double radius) {
  if (end == End::kFork) CutEnd(line, kRetreat * radius);
  if (end == End::kBlunt) ExtendEnd(line, kExtend * radius);
}

/// Extends a line that is shorter than a dot of its thickness.
void MakeDot(ThickLine& line) {
  const Coord widest = *std::max_element(line.thickness_nm.begin(), line.thickness_nm.end());
  const double missing = kLeastLength * static_cast<double>(widest) / 2 - Length(line);
  if (missing <= 0) return;
  ExtendEnd(line, missing / 2);
  Reverse(line);
  ExtendEnd(line, missing / 2);
}

ThickLine MakeLine(const AxisGraph& graph, const std::vector<int>& nodes, double min_radius) {
  ThickLine line;
  for (const int node : nodes) {
    line.points.push_back(graph.PointOf(node));
    line.thickness_nm.push_back(std::llround(2 * graph.Node(node).radius));
  }
  if (nodes.size() > 3 && nodes.front() == nodes.back()) {
    line.closed = true;
    line.points.pop_back();
    line.thickness_nm.pop_back();
    return line;
  }
  for (const int node : {nodes.back(), nodes.front()}) {
    FinishEnd(line, EndAt(graph, node, min_radius), graph.Node(node).radius);
    if (line.points.empty()) return line;
    Reverse(line);
  }
  MakeDot(line);
  return line;
}

/// Returns a dot in the middle of a region of which no two sides meet at less than kFacingAngle,
/// such as a square. The dot is along the longest branch.
std::vector<ThickLine> LoneDot(const AxisGraph& graph, int widest) {
  int farthest = widest;
  double reach = 0;
  for (int i = 0; i < graph.NodeCount(); ++i) {
    const double distance = Distance(graph.PointOf(i), graph.PointOf(widest));
    if (distance > reach) reach = distance, farthest = i;
  }
  if (reach == 0) return {};
  const Coord thickness = std::llround(2 * graph.Node(widest).radius);
  ThickLine line{false, {graph.PointOf(farthest), graph.PointOf(widest)}, {thickness, thickness}};
  CutEnd(line, 0);
  const double half = kLeastLength * graph.Node(widest).radius / 2;
  Reverse(line);
  CutEnd(line, std::max(0.0, reach - half));
  Reverse(line);
  MakeDot(line);
  return {line};
}

std::optional<SkeletalGraph> AxisSkeleton(const PolygonWithHoles& region,
                                          const MedialAxisOptions& options) {
  const std::optional<Boundary> boundary = MakeBoundary(region);
  if (!boundary) return std::nullopt;
  return MakeSkeletalGraph(*boundary, {.tolerance_nm = static_cast<double>(options.tolerance_nm),
                                       .transition_angle = kFacingAngle});
}

}  // namespace

std::vector<ThickLine> MedialAxis(const PolygonWithHoles& region,
                                  const MedialAxisOptions& options) {
  const double min_radius = static_cast<double>(options.min_thickness_nm) / 2;
  const std::optional<SkeletalGraph> skeleton = AxisSkeleton(region, options);
  if (!skeleton) return {};
  AxisGraph graph(*skeleton, min_radius);
  const int widest = graph.Widest();
  if (widest < 0) return {};
  graph.TrimCorners();
  graph.PruneShortBranches();
  const std::vector<std::vector<int>> chains = graph.Lines();
  if (chains.empty()) return LoneDot(graph, widest);
  std::vector<ThickLine> lines;
  for (const std::vector<int>& nodes : chains) {
    ThickLine line = MakeLine(graph, nodes, min_radius);
    if (!line.points.empty()) lines.push_back(SimplifyThickLine(line, options.tolerance_nm));
  }
  return lines;
}

}  // namespace slicefarm::beading
