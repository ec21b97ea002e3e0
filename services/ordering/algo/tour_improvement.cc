#include "services/ordering/algo/tour_improvement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "services/ordering/algo/endpoint_tree.h"

namespace slicefarm::ordering {
namespace {

constexpr size_t kNeighbours = 8;
constexpr int kLongestShift = 3;
/// Gains below a nanometre are rounding, and could go round in circles.
constexpr double kLeastGain = 1.0;
/// Legs that can be moved in memory for the price of judging one move.
constexpr int kLegsPerMove = 16;
/// Exchanges: below five legs the moves find the best by themselves; farther apart than this, they
/// rarely gain.
constexpr int kFewestForExchange = 5;
constexpr int kExchangeWindow = 50;
constexpr int kExchangesPerLeg = 1;
constexpr uint32_t kSeed = 20;
constexpr uint32_t kNowhere = std::numeric_limits<uint32_t>::max();

/// Three places near each other between `count` legs, in order.
std::array<int, 3> Cuts(int count, std::minstd_rand& random) {
  const auto below = [&random](int limit) {
    return static_cast<int>(random() % static_cast<uint32_t>(limit));
  };
  const int window = std::min(count, kExchangeWindow);
  const int first = below(count - window + 1);
  std::array<int, 3> cuts{};
  for (int& cut : cuts) cut = first + below(window + 1);
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

}  // namespace

TourImprovement::TourImprovement(const Journey& journey, std::span<const Leg> legs,
                                 std::vector<Visit> visits)
    : count_(static_cast<int>(legs.size())), visits_(std::move(visits)), position_(legs.size()) {
  FindNeighbours(AddEnds(journey, legs));
  Renumber({0, count_ - 1});
  queued_.assign(legs.size(), 0);
  queue_.resize(legs.size());
  for (int i = 0; i < count_; ++i) Wake(i);
}

std::vector<Point> TourImprovement::AddEnds(const Journey& journey, std::span<const Leg> legs) {
  std::vector<Point> ends;
  ends.reserve(2 * legs.size() + 2);
  reversible_.reserve(legs.size());
  for (const Leg& leg : legs) {
    ends.push_back(leg.start);
    ends.push_back(leg.end);
    reversible_.push_back(leg.reversible);
    all_reversible_ = all_reversible_ && leg.reversible;
  }
  ends.push_back(journey.from);
  if (journey.to) ends.push_back(*journey.to);
  ends_.reserve(ends.size());
  for (const Point end : ends) {
    ends_.push_back({static_cast<double>(end.x), static_cast<double>(end.y)});
  }
  return ends;
}

void TourImprovement::FindNeighbours(const std::vector<Point>& ends) {
  const EndpointTree tree(ends);
  neighbour_begin_.reserve(ends.size() + 1);
  neighbours_.reserve(ends.size() * kNeighbours);
  std::vector<uint32_t> near;
  for (uint32_t end = 0; end < ends.size(); ++end) {
    tree.NearestFew(ends[end], end, kNeighbours, near);
    neighbour_begin_.push_back(static_cast<uint32_t>(neighbours_.size()));
    for (const uint32_t other : near) neighbours_.push_back({other, Distance(end, other)});
  }
  neighbour_begin_.push_back(static_cast<uint32_t>(neighbours_.size()));
}

std::span<const TourImprovement::Neighbour> TourImprovement::NeighboursOf(uint32_t end) const {
  if (end == kNowhere) return {};
  return std::span(neighbours_)
      .subspan(neighbour_begin_[end], neighbour_begin_[end + 1] - neighbour_begin_[end]);
}

uint32_t TourImprovement::EntryAt(int position) const {
  if (position < count_) {
    const Visit visit = visits_[static_cast<size_t>(position)];
    return 2 * visit.leg + (visit.reversed ? 1 : 0);
  }
  const auto to = static_cast<uint32_t>(2 * count_ + 1);
  return to < ends_.size() ? to : kNowhere;
}

uint32_t TourImprovement::ExitAt(int position) const {
  return position < 0 ? static_cast<uint32_t>(2 * count_) : EntryAt(position) ^ 1U;
}

bool TourImprovement::IsExit(uint32_t end) const { return ExitAt(PositionOf(end)) == end; }

int TourImprovement::PositionOf(uint32_t end) const {
  const uint32_t leg = end / 2;
  if (leg < static_cast<uint32_t>(count_)) return position_[leg];
  return end % 2 == 0 ? -1 : count_;
}

double TourImprovement::Distance(uint32_t a, uint32_t b) const {
  if (a == kNowhere || b == kNowhere) return 0;
  const double dx = ends_[a].x - ends_[b].x;
  const double dy = ends_[a].y - ends_[b].y;
  return std::sqrt(dx * dx + dy * dy);
}

double TourImprovement::CrossingCost(uint32_t a, uint32_t b) const {
  if (a == kNowhere || b == kNowhere) return 0;
  const auto [least, greatest] = std::minmax(a, b);
  const auto [known, is_new] =
      parted_.try_emplace(uint64_t{least} << 32 | greatest, false);
  if (is_new) {
    const auto at = [this](uint32_t end) {
      return Point{static_cast<Coord>(ends_[end].x), static_cast<Coord>(ends_[end].y)};
    };
    known->second = barrier_->Parts(at(least), at(greatest));
  }
  return known->second ? kCrossingNm : 0;
}

bool TourImprovement::Reversible(Run run) const {
  if (all_reversible_) return true;
  for (int i = run.first; i <= run.last; ++i) {
    if (!reversible_[visits_[static_cast<size_t>(i)].leg]) return false;
  }
  return true;
}

void TourImprovement::Improve(WorkBudget& budget) {
  ImproveQueued(budget);
  if (count_ < kFewestForExchange) return;
  std::minstd_rand random(kSeed);
  std::vector<Visit> best;
  for (int i = 0; i < kExchangesPerLeg * count_ && budget.moves > 0; ++i) {
    const std::array<int, 3> cuts = Cuts(count_, random);
    if (cuts[0] == cuts[1] || cuts[1] == cuts[2]) continue;
    budget.moves -= 1 + count_ / kLegsPerMove;
    best = visits_;
    double gain = Exchange(cuts[0], cuts[1], cuts[2]);
    gain += ImproveQueued(budget);
    if (gain > kLeastGain) continue;
    visits_ = best;
    Renumber({0, count_ - 1});
  }
}

double TourImprovement::ImproveQueued(WorkBudget& budget) {
  double gained = 0;
  while (queue_size_ > 0 && budget.moves > 0) {
    const uint32_t leg = queue_[queue_head_];
    queue_head_ = queue_head_ + 1 < queue_.size() ? queue_head_ + 1 : 0;
    --queue_size_;
    queued_[leg] = 0;
    double gain = 0;
    do {
      gain = ImproveLeg(leg, budget);
      gained += gain;
    } while (gain > 0 && budget.moves > 0);
  }
  return gained;
}

void TourImprovement::AvoidCrossing(const Barrier& barrier, WorkBudget& budget) {
  barrier_ = &barrier;
  for (int i = -1; i < count_; ++i) {
    if (CrossingCost(ExitAt(i), EntryAt(i + 1)) == 0) continue;
    Wake(i);
    Wake(i + 1);
  }
  ImproveQueued(budget);
  barrier_ = nullptr;
}

double TourImprovement::Exchange(int a, int b, int c) {
  const int joint = a + c - b;
  const auto around = [this](int i) { return Cost(ExitAt(i - 1), EntryAt(i)); };
  const double before = around(a) + around(b) + around(c);
  std::rotate(visits_.begin() + a, visits_.begin() + b, visits_.begin() + c);
  Renumber({a, c - 1});
  for (const int i : {a - 1, a, joint - 1, joint, c - 1, c}) Wake(i);
  return before - around(a) - around(joint) - around(c);
}

double TourImprovement::ImproveLeg(uint32_t leg, WorkBudget& budget) {
  const int position = position_[leg];
  double gain = 0;
  // The travel before the leg and the one behind it, seen from either end.
  for (const int travel : {position - 1, position}) {
    gain = TryTurnAfter(travel, budget);
    if (gain > 0) return gain;
    gain = TryTurnBefore(travel, budget);
    if (gain > 0) return gain;
  }
  for (int size = 1; size <= kLongestShift; ++size) {
    gain = TryShift({position, position + size - 1}, budget);
    if (gain > 0) return gain;
    if (size > 1) gain = TryShift({position - size + 1, position}, budget);
    if (gain > 0) return gain;
  }
  return 0;
}

double TourImprovement::TryTurnAfter(int position, WorkBudget& budget) {
  const uint32_t exit = ExitAt(position);
  const uint32_t entry = EntryAt(position + 1);
  const double old_travel = Cost(exit, entry);
  for (const auto& [near, distance] : NeighboursOf(exit)) {
    if (entry != kNowhere && distance >= old_travel) break;
    if (--budget.moves <= 0) return 0;
    if (!IsExit(near)) continue;
    const double new_travel = Cost(exit, near);
    const int other = PositionOf(near);
    const Run run = other > position ? Run{position + 1, other} : Run{other + 1, position};
    if (run.size() <= 0) continue;
    const uint32_t beyond = EntryAt(other + 1);
    const double gain = old_travel + Cost(near, beyond) - new_travel - Cost(entry, beyond);
    if (gain <= kLeastGain || !Reversible(run)) continue;
    Turn(run, budget);
    return gain;
  }
  return 0;
}

double TourImprovement::TryTurnBefore(int position, WorkBudget& budget) {
  const uint32_t exit = ExitAt(position);
  const uint32_t entry = EntryAt(position + 1);
  const double old_travel = Cost(exit, entry);
  for (const auto& [near, distance] : NeighboursOf(entry)) {
    if (distance >= old_travel) break;
    if (--budget.moves <= 0) return 0;
    if (IsExit(near)) continue;
    const double new_travel = Cost(entry, near);
    const int other = PositionOf(near);
    const Run run = other > position ? Run{position + 1, other - 1} : Run{other, position};
    if (run.size() <= 0) continue;
    const uint32_t beyond = ExitAt(other - 1);
    const double gain = old_travel + Cost(near, beyond) - new_travel - Cost(exit, beyond);
    if (gain <= kLeastGain || !Reversible(run)) continue;
    Turn(run, budget);
    return gain;
  }
  return 0;
}

double TourImprovement::TryShift(Run run, WorkBudget& budget) {
  if (run.first < 0 || run.last >= count_) return 0;
  const uint32_t before = ExitAt(run.first - 1);
  const uint32_t behind = EntryAt(run.last + 1);
  const uint32_t head = EntryAt(run.first);
  const uint32_t tail = ExitAt(run.last);
  const double saved = Cost(before, head) + Cost(tail, behind) - Cost(before, behind);
  if (saved <= kLeastGain) return 0;
  const bool reversible = Reversible(run);
  for (const bool at_head : {true, false}) {
    const uint32_t end = at_head ? head : tail;
    for (const auto& [near, distance] : NeighboursOf(end)) {
      if (distance >= saved) break;
      if (--budget.moves <= 0) return 0;
      if (run.Contains(PositionOf(near))) continue;
      const Shift shift = ShiftTo(near, at_head);
      if (shift.after == run.first - 1 || shift.after == run.last) continue;
      if (shift.reversed && !reversible) continue;
      const double gain = saved - ShiftCost(run, shift);
      if (gain <= kLeastGain) continue;
      Make(run, shift, budget);
      return gain;
    }
  }
  return 0;
}

TourImprovement::Shift TourImprovement::ShiftTo(uint32_t neighbour, bool head) const {
  const bool behind_it = IsExit(neighbour);
  const int position = PositionOf(neighbour);
  return {behind_it ? position : position - 1, behind_it != head};
}

double TourImprovement::ShiftCost(Run run, Shift shift) const {
  const uint32_t left = ExitAt(shift.after);
  const uint32_t right = EntryAt(shift.after + 1);
  uint32_t head = EntryAt(run.first);
  uint32_t tail = ExitAt(run.last);
  if (shift.reversed) std::swap(head, tail);
  return Cost(left, head) + Cost(tail, right) - Cost(left, right);
}

void TourImprovement::Turn(Run run, WorkBudget& budget) {
  budget.moves -= run.size() / kLegsPerMove;
  std::reverse(visits_.begin() + run.first, visits_.begin() + run.last + 1);
  for (int i = run.first; i <= run.last; ++i) {
    Visit& visit = visits_[static_cast<size_t>(i)];
    visit.reversed = !visit.reversed;
  }
  Renumber(run);
  for (const int i : {run.first - 1, run.first, run.last, run.last + 1}) Wake(i);
}

void TourImprovement::Make(Run run, Shift shift, WorkBudget& budget) {
  const bool forward = shift.after > run.last;
  const Run touched = forward ? Run{run.first, shift.after} : Run{shift.after + 1, run.last};
  budget.moves -= touched.size() / kLegsPerMove;
  const auto begin = visits_.begin();
  if (shift.reversed) {
    std::reverse(begin + run.first, begin + run.last + 1);
    for (int i = run.first; i <= run.last; ++i) {
      Visit& visit = visits_[static_cast<size_t>(i)];
      visit.reversed = !visit.reversed;
    }
  }
  std::rotate(begin + touched.first, forward ? begin + run.last + 1 : begin + run.first,
              begin + touched.last + 1);
  Renumber(touched);
  const Run now = forward ? Run{touched.last - run.size() + 1, touched.last}
                          : Run{touched.first, touched.first + run.size() - 1};
  const int gap = forward ? touched.first : touched.last;  // where it came from
  for (const int i : {now.first - 1, now.first, now.last, now.last + 1, gap - 1, gap, gap + 1}) {
    Wake(i);
  }
}

void TourImprovement::Renumber(Run run) {
  for (int i = run.first; i <= run.last; ++i) position_[visits_[static_cast<size_t>(i)].leg] = i;
}

void TourImprovement::Wake(int position) {
  if (position < 0 || position >= count_) return;
  const uint32_t leg = visits_[static_cast<size_t>(position)].leg;
  if (queued_[leg]) return;
  queued_[leg] = 1;
  queue_[(queue_head_ + queue_size_) % queue_.size()] = leg;
  ++queue_size_;
}

}  // namespace slicefarm::ordering
