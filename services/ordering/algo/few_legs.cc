#include "services/ordering/algo/few_legs.h"

#include <algorithm>
#include <array>
#include <limits>

namespace slicefarm::ordering {
namespace {

constexpr int64_t kNoWay = std::numeric_limits<int64_t>::max();
/// number of directed legs: 2k is leg k as it is, 2k + 1 is leg k reversed
constexpr size_t kWays = 2 * kFewLegs;

/// Least cost of having printed a set of legs that ends with a given directed leg.
struct State {
  int64_t cost = kNoWay;
  size_t before = kWays;  ///< previous directed leg; kWays if there is none
};

Point EntryOf(std::span<const Leg> legs, size_t way) {
  const Leg& leg = legs[way / 2];
  return way % 2 == 0 ? leg.start : leg.end;
}

Point ExitOf(std::span<const Leg> legs, size_t way) { return EntryOf(legs, way ^ 1U); }

/// Returns for each leg the set of legs that must be printed before it, as bits.
std::array<size_t, kFewLegs> Predecessors(std::span<const Precedence> precedence) {
  std::array<size_t, kFewLegs> before{};
  for (const Precedence& pair : precedence) before[pair.next] |= size_t{1} << pair.leg;
  return before;
}

}  // namespace

std::vector<Visit> BestOrder(const Journey& journey, std::span<const Leg> legs,
                             const TravelCost& cost) {
  if (legs.empty()) return {};
  const size_t ways = 2 * legs.size();
  const size_t all = (size_t{1} << legs.size()) - 1;
  const auto set_of = [](size_t way) { return size_t{1} << way / 2; };
  const auto before = Predecessors(journey.precedence);
  std::array<std::array<int64_t, kWays>, kWays> between{};
  for (size_t a = 0; a < ways; ++a) {
    for (size_t b = 0; b < ways; ++b)
      if (a / 2 != b / 2) between[a][b] = cost(ExitOf(legs, a), EntryOf(legs, b));
  }
  std::array<std::array<State, kWays>, size_t{1} << kFewLegs> states{};
  for (size_t done = 1; done <= all; ++done) {
    for (size_t way = 0; way < ways; ++way) {
      const size_t others = done & ~set_of(way);
      if (others == done || (way % 2 == 1 && !legs[way / 2].reversible)) continue;
      if ((before[way / 2] & ~others) != 0) continue;
      State& state = states[done][way];
      if (others == 0) state.cost = cost(journey.from, EntryOf(legs, way));
      for (size_t last = 0; last < ways; ++last) {
        const int64_t so_far = states[others][last].cost;
        if (so_far == kNoWay || so_far + between[last][way] >= state.cost) continue;
        state = {so_far + between[last][way], last};
      }
    }
  }
  size_t last = kWays;
  int64_t least = kNoWay;
  for (size_t way = 0; way < ways; ++way) {
    int64_t whole = states[all][way].cost;
    if (whole == kNoWay) continue;
    if (journey.to) whole += cost(ExitOf(legs, way), *journey.to);
    if (whole >= least) continue;
    least = whole;
    last = way;
  }
  std::vector<Visit> visits;
  for (size_t done = all; last != kWays;) {
    visits.push_back({static_cast<uint32_t>(last / 2), last % 2 == 1});
    const size_t way = last;
    last = states[done][way].before;
    done &= ~set_of(way);
  }
  std::ranges::reverse(visits);
  return visits;
}

}  // namespace slicefarm::ordering
