#include "services/ordering/algo/travel_order.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "services/ordering/algo/few_legs.h"
#include "services/ordering/algo/leg_graph.h"
#include "services/ordering/algo/tours/point_tree.h"
#include "services/ordering/algo/tours/tour_search.h"

namespace slicefarm::ordering {
namespace {

Point EntryOf(const TourLeg& leg, bool reversed) { return reversed ? leg.end : leg.start; }
Point ExitOf(const TourLeg& leg, bool reversed) { return reversed ? leg.start : leg.end; }

/// Number of exchanges per leg. More exchanges take more time than they save on the printer.
constexpr int64_t kExchangesPerLeg = 2;
constexpr size_t kNeighbours = 8;
constexpr uint32_t kSeed = 20;

/// Legs that may be visited next, because all their predecessors have been visited.
class Readiness {
 public:
  Readiness(std::span<const Precedence> precedence, size_t legs)
      : precedence_(precedence), waits_for_(legs, 0) {
    for (const Precedence& pair : precedence_) ++waits_for_[pair.next];
  }

  bool IsReady(uint32_t leg) const { return waits_for_[leg] == 0; }

  /// Marks `leg` as visited. Returns the legs that thereby become ready.
  std::vector<uint32_t> Release(uint32_t leg) {
    std::vector<uint32_t> ready;
    for (const Precedence& pair : precedence_) {
      if (pair.leg == leg && --waits_for_[pair.next] == 0) ready.push_back(pair.next);
    }
    return ready;
  }

 private:
  std::span<const Precedence> precedence_;
  std::vector<uint32_t> waits_for_;  ///< number of predecessors not yet visited, indexed by leg
};

/// Returns the order that always continues with the nearest end of a ready leg.
std::vector<Visit> NearestFirst(const Journey& journey, std::span<const TourLeg> legs) {
  std::vector<Vector2> ends;
  ends.reserve(2 * legs.size());
  for (const TourLeg& leg : legs) {
    ends.push_back(ToVector(leg.start));
    ends.push_back(ToVector(leg.end));
  }
  PointTree tree(ends);
  Readiness readiness(journey.precedence, legs.size());
  for (uint32_t leg = 0; leg < legs.size(); ++leg) {
    if (!readiness.IsReady(leg)) tree.Remove(2 * leg);
    if (!readiness.IsReady(leg) || !legs[leg].reversible) tree.Remove(2 * leg + 1);
  }
  std::vector<Visit> visits;
  visits.reserve(legs.size());
  Point at = journey.from;
  while (visits.size() < legs.size()) {
    const uint32_t entry = tree.Nearest(ToVector(at));
    const uint32_t done = entry / 2;
    visits.push_back({done, entry % 2 == 1});
    at = ExitOf(legs[done], entry % 2 == 1);
    tree.Remove(entry);
    if (legs[done].reversible) tree.Remove(entry ^ 1U);
    for (const uint32_t leg : readiness.Release(done)) {
      tree.Restore(2 * leg);
      if (legs[leg].reversible) tree.Restore(2 * leg + 1);
    }
  }
  return visits;
}

/// Surcharge for crossings of a barrier. Results are cached.
class CrossingCharge : public Surcharge {
 public:
  CrossingCharge(const LegGraph& graph, const Barrier& barrier)
      : graph_(graph), barrier_(barrier) {}

  int64_t Of(int32_t a, int32_t b) const override {
    if (graph_.costs().IsNowhere(a) || graph_.costs().IsNowhere(b)) return 0;
    const auto [least, greatest] = std::minmax(a, b);
    const uint64_t edge =
        uint64_t{static_cast<uint32_t>(least)} << 32 | static_cast<uint32_t>(greatest);
    const auto [known, is_new] = parted_.try_emplace(edge, false);
    if (is_new) known->second = barrier_.Parts(graph_.At(least), graph_.At(greatest));
    return known->second ? kCrossingNm : 0;
  }

 private:
  const LegGraph& graph_;
  const Barrier& barrier_;
  mutable std::unordered_map<uint64_t, bool> parted_;
};

void AvoidCrossing(const LegGraph& graph, const Barrier& barrier, TourSearch& search,
                   WorkBudget& budget) {
  const CrossingCharge charge(graph, barrier);
  const FixedEdges fixed(graph.costs().size(), graph.rules().fixed);
  const Tour& tour = search.tour();
  for (size_t i = 0; i < tour.size(); ++i) {
    const int32_t a = tour[i];
    const int32_t b = tour[i + 1 < tour.size() ? i + 1 : 0];
    if (fixed.Has(a, b) || charge.Of(a, b) == 0) continue;
    search.Wake(a);
    search.Wake(b);
  }
  search.Charge(&charge);
  search.Improve(budget);
  search.Charge(nullptr);
}

bool Crosses(const Journey& journey, std::span<const TourLeg> legs, std::span<const Visit> visits) {
  Point at = journey.from;
  for (const Visit& visit : visits) {
    if (journey.barrier->Parts(at, EntryOf(legs[visit.leg], visit.reversed))) return true;
    at = ExitOf(legs[visit.leg], visit.reversed);
  }
  return journey.to && journey.barrier->Parts(at, *journey.to);
}

std::vector<Visit> OrderFew(const Journey& journey, std::span<const TourLeg> legs) {
  const auto length = [](Point a, Point b) { return static_cast<int64_t>(Distance(a, b) + 0.5); };
  const auto charged = [&](Point a, Point b) {
    return length(a, b) + (journey.barrier->Parts(a, b) ? kCrossingNm : 0);
  };
  std::vector<Visit> best = BestOrder(journey, legs, length);
  // Without crossings, the best order by length is also the best order with surcharges.
  return journey.barrier == nullptr || !Crosses(journey, legs, best)
             ? best
             : BestOrder(journey, legs, charged);
}

}  // namespace

std::vector<Visit> OrderByTravel(const Journey& journey, std::span<const TourLeg> legs,
                                 WorkBudget& budget) {
  if (legs.size() <= kFewLegs && budget.moves > 0) {
    budget.moves -= static_cast<int64_t>(legs.size() << legs.size());
    return OrderFew(journey, legs);
  }
  std::vector<Visit> visits = NearestFirst(journey, legs);
  if (legs.empty() || budget.moves <= 0) return visits;
  const LegGraph graph(journey, legs);
  const Neighbours neighbours(graph.costs(), kNeighbours, 0);
  TourSearch search(graph.costs(), neighbours, graph.rules(), graph.TourOf(visits),
                    SearchDepth::kThreeOpt, kSeed);
  search.Improve(budget);
  search.Iterate(kExchangesPerLeg * std::ssize(legs), budget);
  if (journey.barrier != nullptr) AvoidCrossing(graph, *journey.barrier, search, budget);
  return graph.VisitsOf(search.tour());
}

double TravelLength(const Journey& journey, std::span<const TourLeg> legs,
                    std::span<const Visit> visits) {
  double length = 0;
  Point at = journey.from;
  for (const Visit& visit : visits) {
    length += Distance(at, EntryOf(legs[visit.leg], visit.reversed));
    at = ExitOf(legs[visit.leg], visit.reversed);
  }
  return journey.to ? length + Distance(at, *journey.to) : length;
}

}  // namespace slicefarm::ordering
