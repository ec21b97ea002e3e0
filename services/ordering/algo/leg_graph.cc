#include "services/ordering/algo/leg_graph.h"

#include <algorithm>
#include <utility>

namespace slicefarm::ordering {
namespace {

/// Returns the positions of nodes: the ends of the legs, then the ends of the journey.
std::vector<Vector2> PointsOf(const Journey& journey, std::span<const TourLeg> legs) {
  std::vector<Vector2> points;
  points.reserve(2 * legs.size() + 3);
  for (const TourLeg& leg : legs) {
    points.push_back(ToVector(leg.start));
    if (leg.end != leg.start) points.push_back(ToVector(leg.end));
  }
  points.push_back(ToVector(journey.from));
  if (journey.to) points.push_back(ToVector(*journey.to));
  return points;
}

}  // namespace

LegGraph::LegGraph(const Journey& journey, std::span<const TourLeg> legs)
    : costs_(Costs::OfPoints(PointsOf(journey, legs), Metric::kNearest)) {
  ends_.reserve(legs.size());
  entered_.reserve(2 * legs.size());
  for (uint32_t leg = 0; leg < legs.size(); ++leg) {
    const auto start = static_cast<int32_t>(entered_.size());
    const bool has_length = legs[leg].end != legs[leg].start;
    entered_.push_back({leg, false});
    if (has_length) entered_.push_back({leg, true});
    ends_.push_back({start, has_length ? start + 1 : start});
  }
  AddRules(journey, legs);
}

void LegGraph::AddRules(const Journey& journey, std::span<const TourLeg> legs) {
  rules_.first = static_cast<int32_t>(entered_.size());
  rules_.last = journey.to ? rules_.first + 1 : costs_.AddNowhere();
  rules_.fixed.push_back({rules_.last, rules_.first});
  for (size_t leg = 0; leg < legs.size(); ++leg) {
    const auto& [start, end] = ends_[leg];
    if (start == end) continue;
    rules_.fixed.push_back({start, end});
    if (!legs[leg].reversible) rules_.before.push_back({start, end});
  }
  for (const Precedence& pair : journey.precedence)
    rules_.before.push_back({ends_[pair.leg].start, ends_[pair.next].start});
}

Point LegGraph::At(int32_t node) const {
  const Vector2& place = costs_.points()[static_cast<size_t>(node)];
  return {static_cast<Coord>(place.x()), static_cast<Coord>(place.y())};
}

Tour LegGraph::TourOf(std::span<const Visit> visits) const {
  Tour tour = {rules_.first};
  tour.reserve(static_cast<size_t>(costs_.size()));
  for (const Visit& visit : visits) {
    auto [entry, exit] = ends_[visit.leg];
    if (visit.reversed) std::swap(entry, exit);
    tour.push_back(entry);
    if (exit != entry) tour.push_back(exit);
  }
  tour.push_back(rules_.last);
  return tour;
}

std::vector<Visit> LegGraph::VisitsOf(const Tour& tour) const {
  const auto size = static_cast<ptrdiff_t>(tour.size());
  const ptrdiff_t first = std::ranges::find(tour, rules_.first) - tour.begin();
  const ptrdiff_t step = tour[static_cast<size_t>((first + 1) % size)] == rules_.last ? -1 : 1;
  std::vector<Visit> visits;
  visits.reserve(ends_.size());
  for (ptrdiff_t i = 1; i + 1 < size; ++i) {
    const Visit entered =
        entered_[static_cast<size_t>(tour[static_cast<size_t>((first + step * i + size) % size)])];
    if (visits.empty() || visits.back().leg != entered.leg) visits.push_back(entered);
  }
  return visits;
}

}  // namespace slicefarm::ordering
