#include "services/beading/algo/arachne/bead_counts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "services/beading/algo/arachne/count_spans.h"
#include "services/beading/algo/arachne/small_fills.h"

namespace slicefarm::beading {
namespace {

Coord Thickness(double radius) { return std::llround(2 * radius); }

/// Share of the additional bead that a transition causes at a node. It is `full` at the position of
/// the transition, and decreases by 1 per transition length.
struct Ramp {
  double height = 0;
  double full = 0;   ///< height at the position of the transition
  double slope = 0;  ///< fall per nm
};

class CountPlanner {
 public:
  CountPlanner(const BeadingStrategy& strategy, const CountOptions& options, SkeletalGraph& graph,
               std::vector<char>& central)
      : strategy_(strategy), options_(options), graph_(graph), central_(central) {}

  std::vector<BeadCount> Plan() {
    leaving_ = graph_.Leaving();
    JoinAcrossTops();
    SplitWhereThicknessTells();
    leaving_ = graph_.Leaving();
    CountEdges();
    FindTransitions();
    Spread(up_, true);
    Spread(down_, false);
    SplitWhereRampsEnd();
    return Counts();
  }

 private:
  int Split(int half, double t) {
    const SkeletalNode &a = graph_.FromNode(half), &b = graph_.ToNode(half);
    const SkeletalNode node = {
        {std::lerp(a.place.x(), b.place.x(), t), std::lerp(a.place.y(), b.place.y(), t)},
        std::lerp(a.radius, b.radius, t)};
    central_.push_back(central_[half / 2]);
    return graph_.Split(half, node);
  }

  /// Makes edges across the top of a bend central. In a bend of the outline, the axis rises (in
  /// radius) to a top in the middle, too steeply to be central. Beads continue through the bend if
  /// the top has the same number of beads. They also continue if it has one more bead and is nearer
  /// than the transition length. Source: CuraEngine's filterNoncentralRegions, limited to this use.
  void JoinAcrossTops() {
    const std::vector<char> before = central_;
    for (size_t node = 0; node < graph_.nodes.size(); ++node) {
      bool is_central = false;
      graph_.ForEachLeaving(leaving_[node],
                            [&](int half) { is_central = is_central || before[half / 2]; });
      if (!is_central) continue;
      graph_.ForEachLeaving(leaving_[node], [&](int half) {
        if (!before[half / 2]) JoinUpwards(half, before);
      });
    }
  }

  void JoinUpwards(int half, const std::vector<char>& before) {
    const int count = strategy_.OptimalCount(Thickness(graph_.FromNode(half).radius));
    std::vector<int> path;
    double length = 0;
    for (int at = half; at >= 0; at = SteepestUp(graph_.To(at), before)) {
      if (graph_.ToNode(at).radius <= graph_.FromNode(at).radius) return;
      path.push_back(at);
      length += graph_.Length(at);
      const int there = strategy_.OptimalCount(Thickness(graph_.ToNode(at).radius));
      if (there > count + 1) return;
      if (there > count &&
          length > static_cast<double>(strategy_.TransitionLength(std::max(1, count))))
        return;
    }
    for (const int step : path) central_[step / 2] = true;
  }

  /// Returns the half-edge that leaves the node with the steepest rise of the radius; -1 at a top,
  /// and at a node with a central edge.
  int SteepestUp(int node, const std::vector<char>& before) const {
    int best = -1;
    bool is_central = false;
    double steepest = 0;
    graph_.ForEachLeaving(leaving_[node], [&](int half) {
      is_central = is_central || before[half / 2];
      const double length = graph_.Length(half);
      const double rise = graph_.ToNode(half).radius - graph_.FromNode(half).radius;
      if (length == 0 || rise / length <= steepest) return;
      steepest = rise / length;
      best = half;
    });
    return is_central ? -1 : best;
  }

  void SplitWhereThicknessTells() {
    const std::vector<Coord> kinks = strategy_.Kinks();
    const size_t edges = central_.size();
    for (size_t edge = 0; edge < edges; ++edge) {
      if (!central_[edge]) continue;
      int half = static_cast<int>(2 * edge);
      if (graph_.FromNode(half).radius > graph_.ToNode(half).radius) half ^= 1;
      const Coord low = Thickness(graph_.FromNode(half).radius);
      const Coord high = Thickness(graph_.ToNode(half).radius);
      std::vector<Coord> marks;
      for (const Coord kink : kinks)
        if (low < kink && kink < high) marks.push_back(kink);
      for (int n = strategy_.OptimalCount(low); strategy_.TransitionThickness(n) < high; ++n)
        marks.push_back(strategy_.TransitionThickness(n));
      std::sort(marks.begin(), marks.end());
      for (const Coord mark : marks) {
        const double from = graph_.FromNode(half).radius, to = graph_.ToNode(half).radius;
        const double t = (static_cast<double>(mark) / 2 - from) / (to - from);
        const double length = graph_.Length(half);
        if (!(t * length > kLeastPieceNm && (1 - t) * length > kLeastPieceNm)) continue;
        half = Split(half, t);
      }
    }
  }

  void CountEdges() {
    edge_count_.assign(central_.size(), -1);
    for (size_t edge = 0; edge < central_.size(); ++edge) {
      if (!central_[edge]) continue;
      edge_count_[edge] = CountAlong(static_cast<int>(2 * edge));
    }
    edge_count_ = MergedCounts(strategy_, options_, graph_, edge_count_);
    LeaveSmallFillsToWalls();
  }

  void LeaveSmallFillsToWalls() {
    in_small_fill_ = SmallFills(strategy_, graph_, edge_count_);
    const std::vector<char> before = central_;
    for (size_t edge = 0; edge < before.size(); ++edge) {
      if (!before[edge]) continue;
      for (const int half : {static_cast<int>(2 * edge), static_cast<int>(2 * edge + 1)}) {
        const int node = graph_.half_edges[half].from;
        if (!in_small_fill_[node]) continue;
        edge_count_[edge] = std::min(edge_count_[edge], MostWalls(strategy_));
        graph_.ForEachLeaving(leaving_[node], [&](int up) {
          if (!before[up / 2]) LeaveWayUpToWalls(up, before);
        });
      }
    }
  }

  /// Makes the edges from `half` up to the next top central, with the largest number of walls. So
  /// at each of their nodes, the walls are as wide as the node's thickness requires.
  void LeaveWayUpToWalls(int half, const std::vector<char>& before) {
    for (; half >= 0; half = SteepestUp(graph_.To(half), before)) {
      if (graph_.ToNode(half).radius <= graph_.FromNode(half).radius) return;
      central_[half / 2] = true;
      edge_count_[half / 2] = MostWalls(strategy_);
    }
  }

  int CountAlong(int half) const {
    const SkeletalNode &a = graph_.FromNode(half), &b = graph_.ToNode(half);
    const double radius = (a.radius + b.radius) / 2;
    const int count = strategy_.OptimalCount(Thickness(radius));
    if (!options_.deciding_radius || !IsCloseCall(radius, count)) return count;
    const Vector2 middle = {(a.place.x() + b.place.x()) / 2, (a.place.y() + b.place.y()) / 2};
    return strategy_.OptimalCount(Thickness(options_.deciding_radius(middle, radius)));
  }

  bool IsCloseCall(double radius, int count) const {
    const auto to = [&](int lower) {
      return std::abs(2 * radius - static_cast<double>(strategy_.TransitionThickness(lower)));
    };
    return std::min(to(count), count > 0 ? to(count - 1) : to(count)) <
           options_.filter_deviation_nm;
  }

  struct Range {
    int low = std::numeric_limits<int>::max();
    int high = -1;
    bool IsTransition() const { return low < high; }
  };

  Range CountsAround(int node) const {
    Range range;
    graph_.ForEachLeaving(leaving_[node], [&](int half) {
      if (edge_count_[half / 2] < 0) return;
      range.low = std::min(range.low, edge_count_[half / 2]);
      range.high = std::max(range.high, edge_count_[half / 2]);
    });
    return range;
  }

  double Anchor(const Range& range) const {
    return (range.high - range.low) * std::clamp(strategy_.TransitionAnchor(range.low), 0.0, 1.0);
  }

  void FindTransitions() {
    const size_t nodes = graph_.nodes.size();
    up_.assign(nodes, {});
    down_.assign(nodes, {});
    around_.resize(nodes);
    for (size_t node = 0; node < nodes; ++node)
      around_[node] = CountsAround(static_cast<int>(node));
  }

  /// Returns the ramp that begins at a node on the edges with `count` beads. Empty if the node has
  /// no transition, or if `count` is neither the transition's lower nor its higher count.
  Ramp RampAt(int node, int count) const {
    const Range& range = around_[node];
    if (!range.IsTransition() || (count != range.low && count != range.high)) return {};
    const double below = Anchor(range), above = range.high - range.low - below;
    const double full = count == range.low ? below : above;
    return {full, full, 1 / std::max<double>(1, strategy_.TransitionLength(range.low))};
  }

  /// Spreads the ramps outwards from each transition: along the edges with the lower count if `up`,
  /// else along the edges with the higher count.
  void Spread(std::vector<Ramp>& ramps, bool up) {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry> queue;
    const auto reach = [&](int half, const Ramp& from) {
      const int to = graph_.To(half);
      const double height = from.height - from.slope * graph_.Length(half);
      if (height <= ramps[to].height || around_[to].IsTransition()) return;
      ramps[to] = {height, from.full, from.slope};
      queue.emplace(height, to);
    };
    for (size_t node = 0; node < graph_.nodes.size(); ++node) {
      const Range& range = around_[node];
      if (!range.IsTransition()) continue;
      const int count = up ? range.low : range.high;
      const Ramp ramp = RampAt(static_cast<int>(node), count);
      graph_.ForEachLeaving(leaving_[node], [&](int half) {
        if (edge_count_[half / 2] == count) reach(half, ramp);
      });
    }
    while (!queue.empty()) {
      const auto [height, node] = queue.top();
      queue.pop();
      if (height < ramps[node].height) continue;
      const Ramp ramp = ramps[node];
      graph_.ForEachLeaving(leaving_[node], [&](int half) {
        if (edge_count_[half / 2] >= 0) reach(half, ramp);
      });
    }
  }

  /// Returns the ramp on the edge of `half` at the start of `half`: of `up_` if `up`, else of
  /// `down_`. At the node of a transition, the ramp begins only on the edges with the matching
  /// count.
  Ramp RampOn(int half, bool up) const {
    const int node = graph_.half_edges[half].from;
    const int count = edge_count_[half / 2];
    if (!around_[node].IsTransition()) return up ? up_[node] : down_[node];
    return count == (up ? around_[node].low : around_[node].high) ? RampAt(node, count) : Ramp{};
  }

  /// Adds the positions on an edge where the ramps of its two ends reach 0 or meet.
  static void AddKinks(const Ramp& a, const Ramp& b, double length, std::vector<double>& kinks) {
    const double slope = std::max(a.slope, b.slope);
    if (slope == 0) return;
    const double a_end = a.height / slope, b_begin = length - b.height / slope;
    if (a_end < b_begin) {
      if (a.height > 0) kinks.push_back(a_end);
      if (b.height > 0) kinks.push_back(b_begin);
    } else {
      kinks.push_back((a_end + b_begin) / 2);
    }
  }

  static Ramp Later(const Ramp& ramp, double by) {
    return {std::max(0.0, ramp.height - ramp.slope * by), ramp.full, ramp.slope};
  }
  static Ramp Higher(const Ramp& a, const Ramp& b) { return a.height >= b.height ? a : b; }

  void SplitWhereRampsEnd() {
    const size_t edges = central_.size();
    for (size_t edge = 0; edge < edges; ++edge) {
      if (!central_[edge]) continue;
      const int half = static_cast<int>(2 * edge);
      const double length = graph_.Length(half);
      const Ramp ups[] = {RampOn(half, true), RampOn(half ^ 1, true)};
      const Ramp downs[] = {RampOn(half, false), RampOn(half ^ 1, false)};
      std::vector<double> kinks;
      AddKinks(ups[0], ups[1], length, kinks);
      AddKinks(downs[0], downs[1], length, kinks);
      std::sort(kinks.begin(), kinks.end());
      int at = half;
      double done = 0;
      for (const double kink : kinks) {
        if (kink - done < kLeastPieceNm || length - kink < kLeastPieceNm) continue;
        at = Split(at, (kink - done) / (length - done));
        done = kink;
        edge_count_.push_back(edge_count_[edge]);
        up_.push_back(Higher(Later(ups[0], kink), Later(ups[1], length - kink)));
        down_.push_back(Higher(Later(downs[0], kink), Later(downs[1], length - kink)));
        around_.push_back({edge_count_[edge], edge_count_[edge]});
      }
    }
  }

  /// Returns the height of `ramp` at a node, reduced by `other`, the ramp of a transition on the
  /// opposite side. So each of two nearby ramps ends at the position of the other transition.
  static double Share(const Ramp& ramp, const Ramp& other) {
    return ramp.height * (other.full > 0 ? 1 - other.height / other.full : 1);
  }

  static BeadCount Of(double count) {
    constexpr double kNothing = 1e-6;
    const double whole = std::floor(count + kNothing);
    return {static_cast<int>(whole), count - whole < kNothing ? 0 : count - whole};
  }

  /// Returns the number of beads at an isolated top. A middle bead would be a dot there, so the
  /// number is made even: the beads beside the middle are widened until they meet. This gives
  /// exactly the right volume, because a ring halfway to the middle is half as long as the outline.
  int CountAtTop(size_t node) const {
    const int count = strategy_.OptimalCount(Thickness(graph_.nodes[node].radius));
    if (count > MostWalls(strategy_)) return IsInSmallFill(node) ? MostWalls(strategy_) : count;
    const bool has_middle = count % 2 == 1;
    return has_middle && count >= kLeastInnerMiddle ? count - 1 : count;
  }

  /// Returns true if the node is in a small fill. Nodes that were added after this was computed are
  /// on central edges, which are never in a small fill.
  bool IsInSmallFill(size_t node) const {
    return node < in_small_fill_.size() && in_small_fill_[node];
  }

  std::vector<BeadCount> Counts() const {
    std::vector<BeadCount> counts(graph_.nodes.size());
    for (size_t node = 0; node < counts.size(); ++node) {
      const Range& range = around_[node];
      if (range.high >= 0) {
        counts[node] =
            range.IsTransition()
                ? Of(range.low + Anchor(range))
                : Of(range.low + Share(up_[node], down_[node]) - Share(down_[node], up_[node]));
      }
    }
    const std::vector<int> leaving = graph_.Leaving();
    for (size_t node = 0; node < counts.size(); ++node) {
      const double radius = graph_.nodes[node].radius;
      bool is_top = !counts[node].decided() && radius > 0;
      graph_.ForEachLeaving(leaving[node], [&](int half) {
        is_top = is_top && graph_.ToNode(half).radius <= radius;
      });
      if (is_top) counts[node] = {CountAtTop(node), 0};
    }
    return counts;
  }

  const BeadingStrategy& strategy_;
  const CountOptions& options_;
  SkeletalGraph& graph_;
  std::vector<char>& central_;
  std::vector<int> edge_count_;
  std::vector<char> in_small_fill_;  ///< 1 for each node in a small fill
  std::vector<int> leaving_;
  std::vector<Range> around_;    ///< range of the counts of the edges around each node
  std::vector<Ramp> up_, down_;  ///< ramps per node: towards more beads, towards fewer beads
};

}  // namespace

std::vector<BeadCount> PlanBeadCounts(const BeadingStrategy& strategy, const CountOptions& options,
                                      SkeletalGraph& graph, std::vector<char>& central) {
  return CountPlanner(strategy, options, graph, central).Plan();
}

}  // namespace slicefarm::beading
