#include "services/infill/algo/axis/main_axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/geometry/rings/simplify.h"
#include "common/geometry/skeleton/skeletal_graph.h"

namespace slicefarm::infill {
namespace {

/// Tolerance in nm for simplifying the outline before the diagram is computed, and for the axis'
/// curves.
constexpr Coord kAxisToleranceNm = 20'000;
constexpr double kLongestChordNm = 5e6;
/// Length in nm of a line that represents a point.
constexpr Coord kDotNm = 1'000;

double Between(Vector2 a, Vector2 b) { return Hypot(b.x() - a.x(), b.y() - a.y()); }

/// Edges of a medial axis that are kept, as a graph.
class AxisTree {
 public:
  explicit AxisTree(const SkeletalGraph& graph) : graph_(graph), tips_(graph.nodes) {
    const size_t halves = graph.half_edges.size();
    kept_.assign(halves / 2, true);
    degree_.assign(graph.nodes.size(), 0);
    first_.assign(graph.nodes.size() + 1, 0);
    for (const HalfEdge& half : graph.half_edges) ++first_[static_cast<size_t>(half.from) + 1];
    for (size_t i = 0; i < graph.nodes.size(); ++i) {
      degree_[i] = first_[i + 1];
      first_[i + 1] += first_[i];
    }
    leaving_.resize(halves);
    std::vector<int> next = first_;
    for (size_t half = 0; half < halves; ++half)
      leaving_[static_cast<size_t>(next[From(static_cast<int>(half))]++)] = static_cast<int>(half);
  }

  /// Removes small branches from the leaves inwards. Branches of equal depth are removed at the
  /// same time, so that the result does not depend on the numbers of nodes.
  void Prune(const AxisOptions& options) {
    while (true) {
      std::vector<Branch> small;
      for (size_t node = 0; node < degree_.size(); ++node) {
        if (degree_[node] != 1) continue;
        Branch branch = BranchOf(static_cast<int>(node));
        if (branch.fork >= 0 && IsSmall(branch, options)) small.push_back(std::move(branch));
      }
      if (small.empty()) return;
      for (const Branch& branch : small) Remove(branch);
    }
  }

  /// Returns lines that contain each kept edge once. At a node, the straightest pair of edges is
  /// joined to one line, then the straightest pair of the remaining edges.
  std::vector<Polyline> Lines() const {
    const std::vector<int> mates = PairedEdges();
    std::vector<Polyline> lines;
    std::vector<bool> done(kept_.size(), false);
    const auto follow = [&](int half) {
      Polyline& line = lines.emplace_back();
      line.push_back(PointOf(graph_.half_edges[static_cast<size_t>(half)].from));
      while (half >= 0 && !done[static_cast<size_t>(half / 2)]) {
        done[static_cast<size_t>(half / 2)] = true;
        line.push_back(PointOf(graph_.To(half)));
        half = mates[static_cast<size_t>(half ^ 1)];
      }
    };
    for (const bool loops : {false, true}) {
      for (int half = 0; half < static_cast<int>(mates.size()); ++half) {
        const auto at = static_cast<size_t>(half);
        if (kept_[at / 2] && !done[at / 2] && (loops || mates[at] < 0)) follow(half);
      }
    }
    return lines;
  }

  Point Widest() const {
    const auto widest = std::ranges::max_element(graph_.nodes, {}, &SkeletalNode::radius);
    return PointOf(static_cast<int>(widest - graph_.nodes.begin()));
  }

 private:
  struct Branch {
    int leaf = 0;
    int fork = -1;  ///< -1 for a line without forks
    std::vector<int> halves;
  };

  size_t From(int half) const {
    return static_cast<size_t>(graph_.half_edges[static_cast<size_t>(half)].from);
  }
  Point PointOf(int node) const {
    const Vector2 at = graph_.nodes[static_cast<size_t>(node)].place;
    return graph_.origin + Point{std::llround(at.x()), std::llround(at.y())};
  }

  /// Returns a kept half-edge that leaves the node, other than `but`, or -1 if there is none.
  int LeavingKept(int node, int but) const {
    for (int i = first_[static_cast<size_t>(node)]; i < first_[static_cast<size_t>(node) + 1];
         ++i) {
      const int half = leaving_[static_cast<size_t>(i)];
      if (half != but && kept_[static_cast<size_t>(half / 2)]) return half;
    }
    return -1;
  }

  /// Returns the branch from a leaf to the next fork.
  Branch BranchOf(int leaf) const {
    Branch branch;
    branch.leaf = leaf;
    int half = LeavingKept(leaf, -1);
    while (true) {
      branch.halves.push_back(half);
      const int node = graph_.To(half);
      const int degree = degree_[static_cast<size_t>(node)];
      if (degree > 2) branch.fork = node;
      if (degree != 2) return branch;
      half = LeavingKept(node, half ^ 1);
    }
  }

  double Reach(const Branch& branch) const {
    const SkeletalNode& tip = tips_[static_cast<size_t>(branch.leaf)];
    return Between(tip.place, graph_.nodes[static_cast<size_t>(branch.fork)].place) + tip.radius;
  }

  bool IsSmall(const Branch& branch, const AxisOptions& options) const {
    const double radius = graph_.nodes[static_cast<size_t>(branch.fork)].radius;
    return Reach(branch) - radius <= std::max(options.least_nm, options.least_share * radius);
  }

  void Remove(const Branch& branch) {
    const double reach = Reach(branch);
    for (const int half : branch.halves) {
      kept_[static_cast<size_t>(half / 2)] = false;
      --degree_[From(half)];
      --degree_[From(half ^ 1)];
    }
    const auto fork = static_cast<size_t>(branch.fork);
    const double before = Between(tips_[fork].place, graph_.nodes[fork].place) + tips_[fork].radius;
    if (reach > before) tips_[fork] = tips_[static_cast<size_t>(branch.leaf)];
  }

  double CosBetween(int a, int b) const {
    const Vector2 o = graph_.FromNode(a).place, p = graph_.ToNode(a).place,
                  q = graph_.ToNode(b).place;
    const double lengths = graph_.Length(a) * graph_.Length(b);
    if (lengths <= 0) return 1;
    return ((p.x() - o.x()) * (q.x() - o.x()) + (p.y() - o.y()) * (q.y() - o.y())) / lengths;
  }

  /// Returns for each half-edge the half-edge that continues its line at the node that it leaves.
  /// The value is -1 if the line ends there.
  std::vector<int> PairedEdges() const {
    std::vector<int> mates(leaving_.size(), -1);
    struct Pair {
      double cosine;
      int a, b;
    };
    std::vector<Pair> pairs;
    for (size_t node = 0; node < degree_.size(); ++node) {
      pairs.clear();
      for (int i = first_[node]; i < first_[node + 1]; ++i) {
        for (int j = i + 1; j < first_[node + 1]; ++j) {
          const int a = leaving_[static_cast<size_t>(i)], b = leaving_[static_cast<size_t>(j)];
          if (kept_[static_cast<size_t>(a / 2)] && kept_[static_cast<size_t>(b / 2)])
            pairs.push_back({CosBetween(a, b), a, b});
        }
      }
      std::ranges::stable_sort(pairs, {}, &Pair::cosine);
      for (const Pair& pair : pairs) {
        int &a = mates[static_cast<size_t>(pair.a)], &b = mates[static_cast<size_t>(pair.b)];
        if (a < 0 && b < 0) a = pair.b, b = pair.a;
      }
    }
    return mates;
  }

  const SkeletalGraph& graph_;
  /// Farthest circle of all branches pruned at a node, indexed by node.
  std::vector<SkeletalNode> tips_;
  std::vector<bool> kept_;  ///< true if an edge is kept, indexed by edge
  std::vector<int> degree_;
  std::vector<int> first_;    ///< first index of each node in leaving_
  std::vector<int> leaving_;  ///< half-edges, sorted by the node that they leave
};

std::optional<SkeletalGraph> SkeletonOf(const PolygonWithHoles& island) {
  const MultiPolygon simple = Simplify({island}, kAxisToleranceNm);
  for (const PolygonWithHoles* outline : {simple.empty() ? &island : simple.data(), &island}) {
    const std::optional<Boundary> boundary = MakeBoundary(*outline);
    if (!boundary) continue;
    auto graph = MakeSkeletalGraph(
        *boundary, {.tolerance_nm = 1.0 * kAxisToleranceNm, .step_nm = kLongestChordNm});
    if (graph && !graph->nodes.empty()) return graph;
  }
  return std::nullopt;
}

Polyline MiddleOfBox(const Box& box) {
  const Point middle{box.min.x + (box.max.x - box.min.x) / 2,
                     box.min.y + (box.max.y - box.min.y) / 2};
  if (box.max.x - box.min.x >= box.max.y - box.min.y)
    return {{box.min.x, middle.y}, {box.max.x, middle.y}};
  return {{middle.x, box.min.y}, {middle.x, box.max.y}};
}

}  // namespace

std::vector<Polyline> MainAxis(const PolygonWithHoles& island, const AxisOptions& options) {
  const std::optional<SkeletalGraph> graph = SkeletonOf(island);
  if (!graph) return {MiddleOfBox(Bounds(island.outer))};
  AxisTree tree(*graph);
  tree.Prune(options);
  std::vector<Polyline> lines = tree.Lines();
  for (Polyline& line : lines) line = SimplifyLine(line, kAxisToleranceNm);
  std::erase_if(lines, [](const Polyline& line) { return Length(line) <= 0; });
  if (lines.empty()) {
    const Point middle = tree.Widest();
    lines.push_back({middle, middle + Point{kDotNm, 0}});
  }
  return lines;
}

}  // namespace slicefarm::infill
