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

void SeamPlanner::Count(const std::vector<Ring>& rings, const std::vector<int32_t>& chosen,
                        SeamQuality& quality) {
  const auto seam_of = [&](size_t ring) -> const SeamPlace& {
    return rings[ring].places[static_cast<size_t>(chosen[ring])];
  };
  for (size_t i = 0; i < rings.size(); ++i) {
    const SeamPlace& seam = seam_of(i);
    ++quality.loops;
    if (Overhangs(seam)) ++quality.overhanging;
    if (std::ranges::any_of(rings[i].places, IsCorner)) {
      ++quality.with_corner;
      if (IsCorner(seam)) ++quality.on_corner;
    }
    if (rings[i].parent < 0) continue;
    ++quality.followers;
    const double step_mm = ToMm(Distance(seam.at, seam_of(static_cast<size_t>(rings[i].parent)).at));
    if (step_mm > kJumpMm) {
      ++quality.jumps;
    } else {
      quality.steps_mm += step_mm;
    }
  }
}

absl::Status SeamPlanner::Finish(const CancelToken& cancel, JobPlan& plan) {
  for (auto& [object, seams] : objects_) {
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    seams.occupancy.Build();
    const SeamPosition position = PositionOf(object);
    const std::vector<int32_t> chosen =
        CheapestSeams(NodesOf(seams, position), StepCostOf(position));
    for (size_t i = 0; i < seams.rings.size(); ++i) {
      const Ring& ring = seams.rings[i];
      PlanOf(object, plan.layers[static_cast<size_t>(ring.layer)])
          .seams.push_back(ring.places[static_cast<size_t>(chosen[i])].at);
    }
    Count(seams.rings, chosen, plan.seams);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::planning
