#include "services/ordering/algo/travel_order.h"

#include <limits>
#include <utility>

#include "services/ordering/algo/endpoint_tree.h"
#include "services/ordering/algo/tour_improvement.h"

namespace slicefarm::ordering {
namespace {

Point EntryOf(const Leg& leg, bool reversed) { return reversed ? leg.end : leg.start; }
Point ExitOf(const Leg& leg, bool reversed) { return reversed ? leg.start : leg.end; }

/// Up to this many legs, looking at all is faster than building a tree.
constexpr size_t kFewLegs = 24;

std::vector<Visit> NearestFirstOfFew(Point at, std::span<const Leg> legs) {
  std::vector<Visit> visits;
  visits.reserve(legs.size());
  std::vector<uint32_t> left(legs.size());
  for (uint32_t i = 0; i < left.size(); ++i) left[i] = i;
  while (!left.empty()) {
    size_t best = 0;
    bool best_reversed = false;
    double best_distance2 = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < left.size(); ++i) {
      const Leg& leg = legs[left[i]];
      for (const bool reversed : {false, true}) {
        if (reversed && !leg.reversible) continue;
        const double distance2 = SquaredNorm(EntryOf(leg, reversed) - at);
        if (distance2 >= best_distance2) continue;
        best = i;
        best_reversed = reversed;
        best_distance2 = distance2;
      }
    }
    visits.push_back({left[best], best_reversed});
    at = ExitOf(legs[left[best]], best_reversed);
    left.erase(left.begin() + static_cast<ptrdiff_t>(best));
  }
  return visits;
}

std::vector<Visit> NearestFirst(Point at, std::span<const Leg> legs) {
  if (legs.size() <= kFewLegs) return NearestFirstOfFew(at, legs);
  std::vector<Point> ends;
  ends.reserve(2 * legs.size());
  for (const Leg& leg : legs) {
    ends.push_back(leg.start);
    ends.push_back(leg.end);
  }
  EndpointTree tree(ends);
  for (uint32_t i = 0; i < legs.size(); ++i) {
    if (!legs[i].reversible) tree.Remove(2 * i + 1);
  }
  std::vector<Visit> visits;
  visits.reserve(legs.size());
  while (visits.size() < legs.size()) {
    const uint32_t entry = tree.Nearest(at);
    const Leg& leg = legs[entry / 2];
    const bool reversed = entry % 2 == 1;
    visits.push_back({entry / 2, reversed});
    at = ExitOf(leg, reversed);
    tree.Remove(entry);
    if (leg.reversible) tree.Remove(entry ^ 1U);
  }
  return visits;
}

}  // namespace

std::vector<Visit> OrderByTravel(const Journey& journey, std::span<const Leg> legs,
                                 WorkBudget& budget) {
  std::vector<Visit> visits = NearestFirst(journey.from, legs);
  if (legs.empty() || (legs.size() == 1 && !journey.to) || budget.moves <= 0) return visits;
  TourImprovement tour(journey, legs, std::move(visits));
  tour.Improve(budget);
  if (journey.barrier != nullptr) tour.AvoidCrossing(*journey.barrier, budget);
  return tour.visits();
}

double TravelLength(const Journey& journey, std::span<const Leg> legs,
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
