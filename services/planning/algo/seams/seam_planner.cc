#include "services/planning/algo/seams/seam_planner.h"

#include <algorithm>
#include <utility>

#include "services/planning/algo/seams/seam_costs.h"

namespace slicefarm::planning {
namespace {

/// Longer steps are jumps.
constexpr double kJumpMm = 1;

}  // namespace

void SeamPlanner::Look(const SlicedLayer& layer, LayerPlan& plan) {
  (void)plan;
  for (const ObjectSection& section : layer.sections) {
    if (PositionOf(section.object) == SeamPosition::kNearest) continue;
    ObjectSeams& seams = objects_[section.object];
    seams.occupancy.Add(OutlineOf(section), section.z_nm);
    const auto first = static_cast<int32_t>(seams.rings.size());
    int32_t number = 0;
    for (RingPlaces& ring : seams.finder.Next(section)) {
      places_ += ring.places.size();
      seams.rings.push_back({.layer = layers_,
                             .number = {section.object, section.layer, number++},
                             .z_nm = section.z_nm,
                             .parent = ring.below < 0 ? -1 : seams.first_below + ring.below,
                             .places = std::move(ring.places)});
    }
    seams.first_below = first;
  }
  ++layers_;
}

std::vector<SeamNode> SeamPlanner::NodesOf(ObjectSeams& seams, SeamPosition position) {
  std::vector<SeamNode> nodes;
  nodes.reserve(seams.rings.size());
  for (const Ring& ring : seams.rings) {
    SeamNode& node = nodes.emplace_back();
    node.parent = ring.parent;
    std::vector<double> seen;
    for (const SeamPlace& place : ring.places) {
      node.places.push_back(place.at);
      seen.push_back(seams.occupancy.Visibility(place.at, ring.z_nm, place.outward));
    }
    node.costs = SeamCosts(ring.places, seen, position, ring.number);
  }
  return nodes;
}

void SeamPlanner::Count(const std::vector<Ring>& rings, size_t ring,
                        const std::vector<int32_t>& chosen) {
  const auto seam_of = [&](size_t i) -> const SeamPlace& {
    return rings[i].places[static_cast<size_t>(chosen[i])];
  };
  const SeamPlace& seam = seam_of(ring);
  ++quality_.loops;
  if (Overhangs(seam)) ++quality_.overhanging;
  if (std::ranges::any_of(rings[ring].places, IsCorner)) {
    ++quality_.with_corner;
    if (IsCorner(seam)) ++quality_.on_corner;
  }
  if (rings[ring].parent < 0) return;
  ++quality_.followers;
  const double step_mm =
      ToMm(Distance(seam.at, seam_of(static_cast<size_t>(rings[ring].parent)).at));
  if (step_mm > kJumpMm) {
    ++quality_.jumps;
  } else {
    quality_.steps_mm += step_mm;
  }
}

void SeamPlanner::SettleBelow(int32_t end, int32_t object, ObjectSeams& seams,
                              OpenLayers& layers) {
  seams.occupancy.Build();
  const SeamPosition position = PositionOf(object);
  const std::vector<int32_t> chosen = CheapestSeams(NodesOf(seams, position), StepCostOf(position));
  size_t i = seams.settled;
  for (; i < seams.rings.size() && seams.rings[i].layer < end; ++i) {
    const Ring& ring = seams.rings[i];
    PlanOf(object, layers.At(ring.layer))
        .seams.push_back(ring.places[static_cast<size_t>(chosen[i])].at);
    Count(seams.rings, i, chosen);
    places_ -= ring.places.size();
  }
  Forget(i, chosen, seams);
}

/// Of the first `rings` rings the last layer stays, with the seams as their only places: what comes
/// above follows them.
void SeamPlanner::Forget(size_t rings, const std::vector<int32_t>& chosen, ObjectSeams& seams) {
  if (rings == 0) return;
  size_t first = rings;
  while (first > 0 && seams.rings[first - 1].layer == seams.rings[rings - 1].layer) --first;
  for (size_t i = first; i < rings; ++i) {
    Ring& ring = seams.rings[i];
    ring.places = {ring.places[static_cast<size_t>(chosen[i])]};
    ring.parent = -1;
  }
  seams.rings.erase(seams.rings.begin(), seams.rings.begin() + static_cast<ptrdiff_t>(first));
  seams.settled = rings - first;
  seams.first_below -= static_cast<int32_t>(first);
  for (size_t i = seams.settled; i < seams.rings.size(); ++i)
    if (seams.rings[i].parent >= 0) seams.rings[i].parent -= static_cast<int32_t>(first);
}

int32_t SeamPlanner::Settle(OpenLayers& layers) {
  int32_t settled = layers.end();
  const bool too_many = places_ > most_places_;
  for (auto& [object, seams] : objects_) {
    if (seams.settled == seams.rings.size()) continue;
    const int32_t first = seams.rings[seams.settled].layer;
    if (too_many) {
      const int32_t middle = seams.rings[(seams.settled + seams.rings.size()) / 2].layer;
      SettleBelow(std::max(middle, first + 1), object, seams, layers);
    }
    if (seams.settled < seams.rings.size())
      settled = std::min(settled, seams.rings[seams.settled].layer);
  }
  return settled;
}

absl::Status SeamPlanner::Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) {
  for (auto& [object, seams] : objects_) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    SettleBelow(layers.end(), object, seams, layers);
  }
  plan.seams = quality_;
  return absl::OkStatus();
}

}  // namespace slicefarm::planning
