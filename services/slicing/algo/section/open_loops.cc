#include "services/slicing/algo/section/open_loops.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "common/geometry/measure.h"

namespace slicefarm::slicing {
namespace {

constexpr uint32_t kNoEnd = UINT32_MAX;
constexpr double kMaxGapOfLength = 0.3;
constexpr Coord kFirstRadiusNm = 4;
constexpr Coord kRadiusGrowth = 4;

/// Index of a chain's end: 2 c is the first point of chain c, 2 c + 1 its last point.
uint32_t ChainOf(uint32_t end) { return end / 2; }
bool Begins(uint32_t end) { return end % 2 == 0; }
uint32_t Across(uint32_t end) { return end ^ 1; }

/// Returns true if joining the two ends reverses one of the chains: both are first points or both
/// are last points.
bool Turns(uint32_t a, uint32_t b) { return Begins(a) == Begins(b); }

Coord Manhattan(const Polyline& line) {
  Coord length = 0;
  for (size_t i = 1; i < line.size(); ++i)
    length += std::abs(line[i].x - line[i - 1].x) + std::abs(line[i].y - line[i - 1].y);
  return length;
}

struct Candidate {
  bool turns = false;
  double gap_nm = 0;
  uint32_t a = 0;
  uint32_t b = 0;

  friend auto operator<=>(const Candidate&, const Candidate&) = default;
};

class ChainJoiner {
 public:
  explicit ChainJoiner(std::vector<Polyline> chains) : chains_(std::move(chains)) {
    // Chains are sorted by position, so that ties between chain indices are decided by position.
    std::sort(chains_.begin(), chains_.end());
    partner_.assign(2 * chains_.size(), kNoEnd);
    for (uint32_t end = 0; end < partner_.size(); ++end) far_end_.push_back(Across(end));
    for (const Polyline& chain : chains_) {
      const double length = Length(chain);
      length_of_end_.insert(length_of_end_.end(), {length, length});
    }
  }

  ClosedChains Join(Coord max_gap_nm) {
    JoinTouching();
    for (Coord radius = std::min(kFirstRadiusNm, max_gap_nm); radius > 0;) {
      JoinWithin(radius);
      if (radius == max_gap_nm) break;
      radius = std::min(radius * kRadiusGrowth, max_gap_nm);
    }
    return Trace();
  }

 private:
  Point At(uint32_t end) const {
    const Polyline& chain = chains_[ChainOf(end)];
    return Begins(end) ? chain.front() : chain.back();
  }

  std::vector<uint32_t> FreeEnds() const {
    std::vector<uint32_t> ends;
    for (uint32_t end = 0; end < partner_.size(); ++end)
      if (partner_[end] == kNoEnd) ends.push_back(end);
    return ends;
  }

  void Link(uint32_t a, uint32_t b, double gap_nm) {
    partner_[a] = b, partner_[b] = a;
    const double length = length_of_end_[a] + (far_end_[a] == b ? 0 : length_of_end_[b]) + gap_nm;
    const uint32_t far_a = far_end_[a], far_b = far_end_[b];
    far_end_[far_a] = far_b, far_end_[far_b] = far_a;
    length_of_end_[far_a] = length_of_end_[far_b] = length;
  }

  /// Joins ends at the same point: first ends where chains stop with ends where chains begin, then
  /// the remaining ends in pairs.
  void JoinTouching() {
    std::vector<uint32_t> ends = FreeEnds();
    const auto key = [&](uint32_t end) { return std::tuple(At(end), Begins(end), end); };
    std::sort(ends.begin(), ends.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
    for (size_t from = 0; from < ends.size();) {
      size_t to = from;
      while (to < ends.size() && At(ends[to]) == At(ends[from])) ++to;
      const auto middle = std::find_if(ends.begin() + from, ends.begin() + to, Begins);
      size_t stop = from, begin = static_cast<size_t>(middle - ends.begin());
      const size_t stops_end = begin;
      while (stop < stops_end && begin < to) Link(ends[stop++], ends[begin++], 0);
      for (; stop + 1 < stops_end; stop += 2) Link(ends[stop], ends[stop + 1], 0);
      for (; begin + 1 < to; begin += 2) Link(ends[begin], ends[begin + 1], 0);
      from = to;
    }
  }

  bool MayJoin(uint32_t a, uint32_t b, double gap_nm) const {
    return far_end_[a] != b || gap_nm < kMaxGapOfLength * length_of_end_[a];
  }

  void JoinWithin(Coord radius_nm) {
    std::vector<Candidate> candidates = CandidatesWithin(radius_nm);
    std::sort(candidates.begin(), candidates.end());
    for (const Candidate& c : candidates) {
      if (partner_[c.a] != kNoEnd || partner_[c.b] != kNoEnd) continue;
      if (MayJoin(c.a, c.b, c.gap_nm)) {
        Link(c.a, c.b, c.gap_nm);
        largest_gap_nm_ = std::max(largest_gap_nm_, c.gap_nm);
      }
    }
  }

  /// Returns pairs of free ends at most `radius_nm` apart, by a grid with cells of this size.
  std::vector<Candidate> CandidatesWithin(Coord radius_nm) const {
    using Cell = std::pair<Coord, Coord>;
    std::vector<std::pair<Cell, uint32_t>> grid;
    for (const uint32_t end : FreeEnds()) {
      const Point p = At(end);
      grid.push_back({{FloorDiv(p.x, radius_nm), FloorDiv(p.y, radius_nm)}, end});
    }
    std::sort(grid.begin(), grid.end());
    std::vector<Candidate> candidates;
    const auto add_row = [&](uint32_t end, Cell from, Cell to) {
      auto it = std::lower_bound(grid.begin(), grid.end(), std::pair(from, uint32_t{0}));
      for (; it != grid.end() && it->first <= to; ++it) {
        const double gap = Distance(At(end), At(it->second));
        if (it->second > end && gap <= static_cast<double>(radius_nm))
          candidates.push_back({Turns(end, it->second), gap, end, it->second});
      }
    };
    for (const auto& [cell, end] : grid)
      for (Coord x = cell.first - 1; x <= cell.first + 1; ++x)
        add_row(end, {x, cell.second - 1}, {x, cell.second + 1});
    return candidates;
  }

  static Coord FloorDiv(Coord value, Coord by) { return value / by - (value % by < 0 ? 1 : 0); }

  ClosedChains Trace() {
    ClosedChains result;
    result.counts.largest_gap_nm = largest_gap_nm_;
    std::vector<bool> taken(chains_.size(), false);
    for (uint32_t end = 0; end < partner_.size(); ++end) {
      if (partner_[end] != kNoEnd || taken[ChainOf(end)]) continue;
      ++result.counts.dropped;
      Follow(end, taken, [&](uint32_t chain, bool) {
        result.counts.dropped_length_nm += Length(chains_[chain]);
      });
    }
    for (uint32_t chain = 0; chain < chains_.size(); ++chain) {
      if (taken[chain]) continue;
      Polygon loop = Loop(2 * chain, taken);
      if (loop.size() < 3) continue;
      ++result.counts.closed;
      result.loops.push_back(std::move(loop));
    }
    return result;
  }

  /// Calls visit(chain, forward) for each chain of the line that begins at the end `enter`.
  template <typename Visit>
  void Follow(uint32_t enter, std::vector<bool>& taken, Visit visit) const {
    while (enter != kNoEnd && !taken[ChainOf(enter)]) {
      taken[ChainOf(enter)] = true;
      visit(ChainOf(enter), Begins(enter));
      enter = partner_[Across(enter)];
    }
  }

  Polygon Loop(uint32_t enter, std::vector<bool>& taken) const {
    Polygon loop;
    Coord forward_length = 0;
    Follow(enter, taken, [&](uint32_t chain, bool forward) {
      const Polyline& line = chains_[chain];
      forward_length += forward ? Manhattan(line) : -Manhattan(line);
      if (forward) {
        loop.insert(loop.end(), line.begin(), line.end());
      } else {
        loop.insert(loop.end(), line.rbegin(), line.rend());
      }
    });
    if (forward_length < 0) std::reverse(loop.begin(), loop.end());
    loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    return loop;
  }

  std::vector<Polyline> chains_;
  std::vector<uint32_t> partner_;  ///< end to which each end is joined
  /// free end at the other side of the joined line, indexed by free end
  std::vector<uint32_t> far_end_;
  /// length of the joined line including its gaps, indexed by free end
  std::vector<double> length_of_end_;
  double largest_gap_nm_ = 0;
};

}  // namespace

void GapCounts::Add(const GapCounts& other) {
  closed += other.closed;
  dropped += other.dropped;
  largest_gap_nm = std::max(largest_gap_nm, other.largest_gap_nm);
  dropped_length_nm += other.dropped_length_nm;
}

ClosedChains CloseChains(std::vector<Polyline> chains, Coord max_gap_nm) {
  if (chains.empty()) return {};
  return ChainJoiner(std::move(chains)).Join(max_gap_nm);
}

}  // namespace slicefarm::slicing
