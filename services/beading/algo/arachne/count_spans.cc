#include "services/beading/algo/arachne/count_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

namespace slicefarm::beading {
namespace {

/// Factor on the allowed deviation of beads, for a span that is too short for its half of a
/// transition or for a middle bead.
constexpr double kShortDeviation = 3;
/// Smallest length of a span that gets a middle bead. In a shorter one, the bead would be at
/// most 1 mm long, because it ends before other beads begin.
constexpr double kLeastMiddleNm = 1'500'000;
/// Smallest length of a neck that gets a bead between the outermost beads. In a shorter one, the
/// bead would be at most about 0.4 mm long.
constexpr double kLeastNeckNm = 1'000'000;

/// Spans and their neighbours. A span is a set of connected central edges with the same bead
/// count.
class CountSpans {
 public:
  CountSpans(const SkeletalGraph& graph, const std::vector<int>& counts)
      : parent_(counts.size()), data_(counts.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (size_t edge = 0; edge < counts.size(); ++edge) {
      const int half = static_cast<int>(2 * edge);
      const double a = graph.FromNode(half).radius, b = graph.ToNode(half).radius;
      data_[edge] = {counts[edge], graph.Length(half), std::min(a, b), std::max(a, b), 0, {}};
    }
    const std::vector<int> leaving = graph.Leaving();
    for (const int first : leaving) {
      std::vector<int> around;
      bool rises = false;
      graph.ForEachLeaving(first, [&](int half) {
        if (counts[half / 2] >= 0) around.push_back(half / 2);
        rises = rises ||
                (counts[half / 2] < 0 && graph.ToNode(half).radius > graph.FromNode(half).radius);
      });
      for (size_t i = 0; i < around.size(); ++i)
        for (size_t j = 0; j < i; ++j) Meet(around[i], around[j]);
      if (rises && !around.empty()) ++data_[Find(around.front())].steep_ends;
    }
  }

  int CountOf(int edge) { return data_[Find(edge)].count; }

  /// Merges spans into neighbouring ones, the shortest first.
  void Merge(const BeadingStrategy& strategy, const CountOptions& options) {
    std::set<std::pair<double, int>> queue;
    for (int edge = 0; edge < static_cast<int>(parent_.size()); ++edge)
      if (Find(edge) == edge && data_[edge].count >= 0) queue.emplace(data_[edge].length, edge);
    while (!queue.empty()) {
      const auto [length, span] = *queue.begin();
      queue.erase(queue.begin());
      if (Find(span) != span || data_[span].length != length) continue;
      const int into = BestNeighbour(span, strategy, options);
      if (into < 0) {
        if (data_[span].beside.empty()) TakeOutShortMiddle(data_[span], strategy, options);
        continue;
      }
      data_[span].count = data_[into].count;
      const int joined = Absorb(span);
      queue.emplace(data_[joined].length, joined);
    }
  }

 private:
  struct Data {
    int count = -1;
    double length = 0;
    double min_radius = 0, max_radius = 0;
    int steep_ends = 0;  ///< number of ends where the part thickens too steeply to be central
    /// Neighbouring spans with other counts; may be outdated, so use Find.
    std::set<int> beside;
  };

  int Find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void Meet(int a, int b) {
    a = Find(a);
    b = Find(b);
    if (a == b) return;
    if (data_[a].count == data_[b].count) {
      Unite(a, b);
    } else {
      data_[a].beside.insert(b);
      data_[b].beside.insert(a);
    }
  }

  int Unite(int a, int b) {
    if (data_[a].beside.size() < data_[b].beside.size()) std::swap(a, b);
    parent_[b] = a;
    data_[a].length += data_[b].length;
    data_[a].min_radius = std::min(data_[a].min_radius, data_[b].min_radius);
    data_[a].max_radius = std::max(data_[a].max_radius, data_[b].max_radius);
    data_[a].steep_ends += data_[b].steep_ends;
    data_[a].beside.merge(data_[b].beside);
    return a;
  }

  std::vector<int> Neighbours(int span) {
    std::vector<int> neighbours;
    for (const int other : data_[span].beside)
      if (const int root = Find(other); root != span) neighbours.push_back(root);
    std::sort(neighbours.begin(), neighbours.end());
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    return neighbours;
  }

  /// Unites the span with all neighbours that now have the same count.
  int Absorb(int span) {
    for (const int other : Neighbours(span))
      if (data_[other].count == data_[span].count) span = Unite(span, Find(other));
    return span;
  }

  /// Returns the best neighbour to merge the span into; -1 if it must stay.
  int BestNeighbour(int span, const BeadingStrategy& strategy, const CountOptions& options) {
    const std::vector<int> neighbours = Neighbours(span);
    const bool short_middle = HasShortMiddle(data_[span], strategy) && HaveOneCount(neighbours);
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (const int other : neighbours) {
      double deviation = Deviation(data_[span], data_[other].count, strategy);
      const bool allowed = deviation <= options.filter_deviation_nm &&
                           data_[span].length <= options.filter_distance_nm;
      const bool too_short = short_middle || (neighbours.size() == 1 &&
                                              !HasSpace(data_[span], data_[other], strategy));
      if (!allowed && !(too_short && deviation <= kShortDeviation * options.filter_deviation_nm))
        continue;
      if (deviation >= least) continue;
      least = deviation;
      best = other;
    }
    return best;
  }

  /// Returns the total change of bead widths, in nm, if the span gets `count` beads instead of
  /// its own number.
  static double Deviation(const Data& data, int count, const BeadingStrategy& strategy) {
    const int lower = std::min(data.count, count);
    const auto limit = static_cast<double>(strategy.TransitionThickness(lower)) / 2;
    const double beyond = data.count > count ? data.max_radius - limit : limit - data.min_radius;
    return (count % 2 == 1 ? 2 : 1) * std::abs(data.count - count) * std::max(0.0, beyond);
  }

  bool HaveOneCount(const std::vector<int>& spans) const {
    return std::ranges::all_of(
        spans, [&](int span) { return data_[span].count == data_[spans.front()].count; });
  }

  /// Returns true if the span has a middle bead that is hardly worth a travel.
  static bool HasShortMiddle(const Data& data, const BeadingStrategy& strategy) {
    return data.count % 2 == 1 && data.count >= kLeastInnerMiddle &&
           data.count <= MostWalls(strategy) && data.length < kLeastMiddleNm;
  }

  /// Removes a short middle bead from a span without neighbours: a neck between steep sides.
  static void TakeOutShortMiddle(Data& data, const BeadingStrategy& strategy,
                                 const CountOptions& options) {
    if (IsShortNeck(data)) return SplitMiddle(data, strategy, options);
    if (!HasShortMiddle(data, strategy)) return;
    const double fewer = Deviation(data, data.count - 1, strategy);
    const double more = Deviation(data, data.count + 1, strategy);
    if (std::min(fewer, more) > kShortDeviation * options.filter_deviation_nm) return;
    data.count += fewer < more ? -1 : 1;
  }

  /// Returns true for a neck where removing the middle bead would widen the outermost beads.
  static bool IsShortNeck(const Data& data) {
    return data.count % 2 == 1 && data.count < kLeastInnerMiddle && data.steep_ends >= 2 &&
           data.length < kLeastNeckNm;
  }

  /// Splits the middle bead of a neck. It would end before the two beads at either end of the neck
  /// and be a dot between them. Its halves instead continue into these two beads.
  static void SplitMiddle(Data& data, const BeadingStrategy& strategy,
                          const CountOptions& options) {
    if (Deviation(data, data.count + 1, strategy) <= options.filter_deviation_nm) ++data.count;
  }

  /// Returns true if the span is long enough for its half of the transition.
  static bool HasSpace(const Data& data, const Data& other, const BeadingStrategy& strategy) {
    const int lower = std::min(data.count, other.count);
    const double anchor = strategy.TransitionAnchor(lower);
    const double share = data.count > other.count ? 1 - anchor : anchor;
    return data.length >= share * static_cast<double>(strategy.TransitionLength(lower));
  }

  std::vector<int> parent_;
  std::vector<Data> data_;
};

}  // namespace

std::vector<int> MergedCounts(const BeadingStrategy& strategy, const CountOptions& options,
                              const SkeletalGraph& graph, std::vector<int> counts) {
  CountSpans spans(graph, counts);
  spans.Merge(strategy, options);
  for (size_t edge = 0; edge < counts.size(); ++edge)
    if (counts[edge] >= 0) counts[edge] = spans.CountOf(static_cast<int>(edge));
  return counts;
}

}  // namespace slicefarm::beading
