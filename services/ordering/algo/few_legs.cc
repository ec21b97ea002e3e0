#include "services/ordering/algo/few_legs.h"

#include <algorithm>
#include <array>
#include <limits>

namespace slicefarm::ordering {
namespace {

constexpr int64_t kNoPath = std::numeric_limits<int64_t>::max();
/// number of directed legs: index 2k is leg k, 2k + 1 is leg k reversed
constexpr size_t kDirectedLegs = 2 * kFewLegs;

/// Smallest cost of printing a set of legs, if the directed leg of this state is printed last.
struct State {
  int64_t cost = kNoPath;
  size_t before = kDirectedLegs;  ///< previous directed leg; kDirectedLegs if there is none
};

Point EntryOf(std::span<const TourLeg> legs, size_t path) {
  const TourLeg& leg = legs[path / 2];
  return path % 2 == 0 ? leg.start : leg.end;
}

Point ExitOf(std::span<const TourLeg> legs, size_t path) { return EntryOf(legs, path ^ 1U); }

/// Returns for each leg the set of legs that must be printed before it, as bits.
std::array<size_t, kFewLegs> Predecessors(std::span<const Precedence> precedence) {
  std::array<size_t, kFewLegs> before{};
  for (const Precedence& pair : precedence) before[pair.next] |= size_t{1} << pair.leg;
  return before;
}

}  // namespace

std::vector<Visit> BestOrder(const Journey& journey, std::span<const TourLeg> legs,
                             const TravelCost& cost) {
  if (legs.empty()) return {};
  const size_t paths = 2 * legs.size();
  const size_t all = (size_t{1} << legs.size()) - 1;
  const auto set_of = [](size_t path) { return size_t{1} << path / 2; };
  const auto before = Predecessors(journey.precedence);
  std::array<std::array<int64_t, kDirectedLegs>, kDirectedLegs> between{};
  for (size_t a = 0; a < paths; ++a) {
    for (size_t b = 0; b < paths; ++b)
      if (a / 2 != b / 2) between[a][b] = cost(ExitOf(legs, a), EntryOf(legs, b));
  }
  std::vector<std::array<State, kDirectedLegs>> states(all + 1);
  for (size_t done = 1; done <= all; ++done) {
    for (size_t path = 0; path < paths; ++path) {
      const size_t others = done & ~set_of(path);
      if (others == done || (path % 2 == 1 && !legs[path / 2].reversible)) continue;
      if ((before[path / 2] & ~others) != 0) continue;
      State& state = states[done][path];
      if (others == 0) state.cost = cost(journey.from, EntryOf(legs, path));
      for (size_t last = 0; last < paths; ++last) {
        const int64_t so_far = states[others][last].cost;
        if (so_far == kNoPath || so_far + between[last][path] >= state.cost) continue;
        state = {so_far + between[last][path], last};
      }
    }
  }
  size_t last = kDirectedLegs;
  int64_t least = kNoPath;
  for (size_t path = 0; path < paths; ++path) {
    int64_t whole = states[all][path].cost;
    if (whole == kNoPath) continue;
    if (journey.to) whole += cost(ExitOf(legs, path), *journey.to);
    if (whole >= least) continue;
    least = whole;
    last = path;
  }
  std::vector<Visit> visits;
  for (size_t done = all; last != kDirectedLegs;) {
    visits.push_back({static_cast<uint32_t>(last / 2), last % 2 == 1});
    const size_t path = last;
    last = states[done][path].before;
    done &= ~set_of(path);
  }
  std::ranges::reverse(visits);
  return visits;
}

}  // namespace slicefarm::ordering
