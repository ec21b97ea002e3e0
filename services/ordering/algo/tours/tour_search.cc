#include "services/ordering/algo/tours/tour_search.h"

#include <algorithm>
#include <utility>

namespace slicefarm::ordering {
namespace {

constexpr int32_t kLongestShift = 3;
/// Reversing this many nodes takes as much time as judging one move.
constexpr int32_t kNodesPerMove = 16;
/// Smallest number of nodes for exchanges. In smaller tours, the moves alone find the best tour.
constexpr int32_t kFewestForExchange = 8;
constexpr int32_t kLongestExchange = 50;
/// Largest number of moves in a chain.
constexpr int kLongestChain = 6;

}  // namespace

TourSearch::TourSearch(const Costs& costs, const Neighbours& neighbours, const TourRules& rules,
                       Tour tour, SearchDepth depth, uint32_t seed)
    : costs_(costs),
      neighbours_(neighbours),
      rules_(rules),
      fixed_(costs.size(), rules.fixed),
      depth_(depth),
      tour_(std::move(tour)),
      random_(seed),
      queue_(static_cast<size_t>(costs.size())),
      queued_(static_cast<size_t>(costs.size()), 0) {
  if (depth == SearchDepth::kNone) return;
  for (const int32_t node : tour_.order()) Wake(node);
}

void TourSearch::Wake(int32_t node) {
  uint8_t& queued = queued_[static_cast<size_t>(node)];
  if (queued) return;
  queued = 1;
  size_t tail = queue_head_ + queue_size_;
  if (tail >= queue_.size()) tail -= queue_.size();
  queue_[tail] = node;
  ++queue_size_;
}

void TourSearch::Improve(WorkBudget& budget) {
  while (queue_size_ > 0 && budget.moves > 0) {
    const int32_t node = queue_[queue_head_];
    queue_head_ = queue_head_ + 1 < queue_.size() ? queue_head_ + 1 : 0;
    --queue_size_;
    queued_[static_cast<size_t>(node)] = 0;
    while (budget.moves > 0) {
      const int64_t gain = ImproveFrom(node, budget);
      if (gain <= 0) break;
      gained_ += gain;
    }
  }
}

void TourSearch::Iterate(int64_t exchanges, WorkBudget& budget) {
  if (tour_.size() < kFewestForExchange) return;
  for (; exchanges > 0 && budget.moves > 0; --exchanges) {
    turns_.clear();
    const int64_t before = gained_;
    int64_t gain = 0;
    --budget.moves;
    if (!Exchange(budget, &gain)) continue;
    gained_ += gain;
    Improve(budget);
    if (gained_ >= before) continue;
    Undo(0);
    gained_ = before;
  }
}

int64_t TourSearch::ImproveFrom(int32_t node, WorkBudget& budget) {
  for (const bool forward : {true, false}) {
    const int32_t first = forward ? tour_.Next(node) : tour_.Previous(node);
    if (fixed_.Has(node, first)) continue;
    const int64_t gain = ImproveAlong(PathFrom(first, forward), budget);
    if (gain > 0) return gain;
  }
  return 0;
}

int64_t TourSearch::ImproveAlong(TourPath path, WorkBudget& budget) {
  const size_t turns = turns_.size();
  const int32_t last = At(path, tour_.size() - 1);
  const int links = depth_ == SearchDepth::kChains ? kLongestChain : 1;
  std::array<int32_t, 6 * kLongestChain> touched{};
  size_t count = 0;
  int64_t open = Cost(last, path.first);
  for (int link = 0; link < links; ++link) {
    const Found found = Search(path, open, budget);
    const Move& move = found.gaining.gain > 0 ? found.gaining : found.opening;
    if (move.gain <= 0 && (move.open_gain <= 0 || link + 1 == links)) break;
    for (const int32_t cut : {-1, move.cut1, move.cut2}) {
      touched[count++] = At(path, cut < 0 ? 0 : cut);
      touched[count++] = At(path, cut < 0 ? tour_.size() - 1 : cut + 1);
    }
    path = Make(path, move, budget);
    open = move.open_gain;
    if (move.gain <= 0) continue;
    for (size_t i = 0; i < count; ++i) Wake(touched[i]);
    return move.gain;
  }
  Undo(turns);
  return 0;
}

TourSearch::Found TourSearch::Search(const TourPath& path, int64_t gain, WorkBudget& budget) const {
  Found found;
  for (const Neighbour& near : neighbours_.Of(path.first)) {
    if (near.length >= gain) break;
    const int64_t gain1 = gain - Cost(path.first, near);
    const int32_t index = IndexOf(path, near.node);
    if (gain1 <= 0 || index == 1 || index == tour_.size() - 1) continue;
    SearchTurned(path, index - 1, gain1, found, budget);
    if (depth_ == SearchDepth::kTwoOptAndOrOpt && found.gaining.gain > 0) break;
    SearchSplit(path, index, gain1, found, budget);
    if (found.gaining.gain > 0) break;
  }
  return found;
}

// Searches moves that reverse the section up to `cut`, so that the path begins with the section's
// last node.
void TourSearch::SearchTurned(const TourPath& path, int32_t cut, int64_t gain, Found& found,
                              WorkBudget& budget) const {
  const int32_t head = At(path, cut);
  const int32_t beyond = At(path, cut + 1);
  const int32_t last = At(path, tour_.size() - 1);
  --budget.moves;
  if (fixed_.Has(head, beyond)) return;
  const int64_t open = gain + Cost(head, beyond);
  Judge(path, {open - Cost(head, last), open, cut, cut, Join::kTurnFirst}, found);
  for (const Neighbour& near : neighbours_.Of(head)) {
    if (near.length >= open) break;
    const int64_t open1 = open - Cost(head, near);
    const int32_t index = IndexOf(path, near.node);
    if (open1 <= 0 || index == cut + 1 || index == cut - 1) continue;
    --budget.moves;
    const bool later = index > cut;
    const int32_t head2 = At(path, later ? index - 1 : index + 1);
    if (fixed_.Has(near.node, head2)) continue;
    const int64_t open2 = open1 + Cost(near.node, head2);
    const Move move =
        later ? Move{open2 - Cost(head2, last), open2, cut, index - 1, Join::kSwapTurned}
              : Move{open2 - Cost(head2, last), open2, index, cut, Join::kSwapTurningFirst};
    Judge(path, move, found);
  }
}

// Searches moves that join the ends of the section up to `cut` into a ring. They open the ring next
// to a node that is near the remaining path, and insert it there.
void TourSearch::SearchSplit(const TourPath& path, int32_t cut, int64_t gain, Found& found,
                             WorkBudget& budget) const {
  const int32_t end = At(path, cut);
  const int32_t rest = At(path, cut + 1);
  const int32_t last = At(path, tour_.size() - 1);
  --budget.moves;
  if (fixed_.Has(end, rest)) return;
  const int64_t open = gain + Cost(end, rest);
  for (const Neighbour& near : neighbours_.Of(rest)) {
    if (near.length >= open) break;
    const int64_t open1 = open - Cost(rest, near);
    const int32_t index = IndexOf(path, near.node);
    if (open1 <= 0 || index >= cut) continue;
    --budget.moves;
    const int32_t behind = At(path, index + 1);
    if (!fixed_.Has(near.node, behind)) {
      const int64_t open2 = open1 + Cost(near.node, behind);
      Judge(path, {open2 - Cost(behind, last), open2, index, cut, Join::kSwap}, found);
    }
    if (index == 0) continue;
    const int32_t before = At(path, index - 1);
    if (fixed_.Has(near.node, before)) continue;
    const int64_t open2 = open1 + Cost(near.node, before);
    Judge(path, {open2 - Cost(before, last), open2, index - 1, cut, Join::kTurnBoth}, found);
  }
}

bool TourSearch::ShortEnough(const Move& move) const {
  if (depth_ != SearchDepth::kTwoOptAndOrOpt || move.join == Join::kTurnFirst) return true;
  const int32_t one = move.cut1 + 1;
  const int32_t two = move.cut2 - move.cut1;
  const int32_t three = tour_.size() - move.cut2 - 1;
  return std::min({one, two, three}) <= kLongestShift;
}

void TourSearch::Judge(const TourPath& path, const Move& move, Found& found) const {
  const bool gains = move.gain > found.gaining.gain;
  const bool opens = depth_ == SearchDepth::kChains && move.open_gain > found.opening.open_gain;
  if (!(gains || opens) || !ShortEnough(move) || !Allowed(path, move)) return;
  if (gains) found.gaining = move;
  if (opens) found.opening = move;
}

bool TourSearch::Allowed(const TourPath& path, const Move& move) const {
  if (rules_.before.empty()) return true;
  const int32_t size = tour_.size();
  const int32_t one = move.cut1 + 1;
  const int32_t both = move.cut2 + 1;
  const auto index_after = [&](int32_t node) {
    const int32_t index = IndexOf(path, node);
    if (index >= both) return index;
    const bool in_first = index < one;
    switch (move.join) {
      case Join::kTurnFirst:
        return both - 1 - index;
      case Join::kSwapTurned:
        return in_first ? both - one + index : both - 1 - index;
      case Join::kSwapTurningFirst:
        return in_first ? both - 1 - index : index - one;
      case Join::kSwap:
        return in_first ? both - one + index : index - one;
      case Join::kTurnBoth:
        return in_first ? one - 1 - index : both - 1 - index + one;
    }
    return index;
  };
  const int32_t first = index_after(rules_.first);
  const int32_t last = index_after(rules_.last);
  const bool forward = (last + 1 < size ? last + 1 : 0) == first;
  return std::ranges::all_of(rules_.before, [&](const NodePair& pair) {
    const int32_t a = index_after(pair.a) - first;
    const int32_t b = index_after(pair.b) - first;
    const int32_t steps_a = a < 0 ? a + size : a;
    const int32_t steps_b = b < 0 ? b + size : b;
    if (forward) return steps_a < steps_b;
    return steps_b != 0 && (steps_a == 0 || steps_a > steps_b);
  });
}

TourSearch::TourPath TourSearch::Turned(const TourPath& path, int32_t from, int32_t to,
                                        WorkBudget& budget) {
  if (from >= to) return path;
  const int32_t last = At(path, tour_.size() - 1);
  const int32_t a = At(path, from);
  const int32_t b = At(path, to);
  const Reversal turn = path.forward ? tour_.Reverse(a, b) : tour_.Reverse(b, a);
  turns_.push_back(turn);
  budget.moves -= ArrayTour::Length(turn, tour_.size()) / kNodesPerMove;
  // Reverse may have reversed all other nodes; the path's direction in memory is then the
  // opposite.
  const int32_t first = from == 0 ? b : path.first;
  return PathFrom(first, tour_.Next(last) == first);
}

TourSearch::TourPath TourSearch::Make(const TourPath& path, const Move& move, WorkBudget& budget) {
  const int32_t one = move.cut1 + 1;
  const int32_t end = move.cut2;
  const int32_t two = end + 1 - one;
  switch (move.join) {
    case Join::kTurnFirst:
      return Turned(path, 0, end, budget);
    case Join::kSwapTurned:
      return Turned(Turned(path, 0, end, budget), two, end, budget);
    case Join::kSwapTurningFirst:
      return Turned(Turned(path, 0, end, budget), 0, two - 1, budget);
    case Join::kSwap:
      return Turned(Turned(Turned(path, 0, end, budget), 0, two - 1, budget), two, end, budget);
    case Join::kTurnBoth:
      return Turned(Turned(path, 0, one - 1, budget), one, end, budget);
  }
  return path;
}

void TourSearch::Undo(size_t turns) {
  while (turns_.size() > turns) {
    tour_.Reverse(turns_.back());
    turns_.pop_back();
  }
}

int32_t TourSearch::Below(int32_t limit) {
  return static_cast<int32_t>((uint64_t{random_()} * static_cast<uint64_t>(limit)) >> 32);
}

// If an edge to be cut is fixed, the edge after it is cut instead.
bool TourSearch::Exchange(WorkBudget& budget, int64_t* gain) {
  const int32_t size = tour_.size();
  const int32_t longest = std::min(kLongestExchange, size / 2 - 1);
  int32_t start = Below(size);
  const auto is_fixed = [&](const TourPath& path, int32_t index) {
    return fixed_.Has(At(path, index), At(path, index + 1));
  };
  if (is_fixed(PathFrom(tour_.At(start), true), -1)) start = start + 1 < size ? start + 1 : 0;
  const TourPath path = PathFrom(tour_.At(start), true);
  int32_t one = 1 + Below(longest);
  if (is_fixed(path, one - 1)) ++one;
  int32_t both = one + 1 + Below(longest);
  if (is_fixed(path, both - 1)) ++both;
  if (both >= size) return false;
  const Move move{0, 0, one - 1, both - 1, Join::kSwap};
  const int32_t last = At(path, size - 1);
  const std::array<int32_t, 6> ends = {last,          path.first,         At(path, one - 1),
                                       At(path, one), At(path, both - 1), At(path, both)};
  if (fixed_.Has(ends[0], ends[1]) || fixed_.Has(ends[2], ends[3]) || fixed_.Has(ends[4], ends[5]))
    return false;
  if (!Allowed(path, move)) return false;
  *gain = Cost(ends[0], ends[1]) + Cost(ends[2], ends[3]) + Cost(ends[4], ends[5]) -
          Cost(ends[0], ends[3]) - Cost(ends[4], ends[1]) - Cost(ends[2], ends[5]);
  Make(path, move, budget);
  for (const int32_t node : ends) Wake(node);
  return true;
}

}  // namespace slicefarm::ordering
