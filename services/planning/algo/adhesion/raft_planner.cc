#include "services/planning/algo/adhesion/raft_planner.h"

#include <algorithm>
#include <utility>

#include "common/geometry/moved.h"
#include "common/geometry/offset/offset.h"
#include "services/planning/algo/adhesion/room.h"

namespace slicefarm::planning {
namespace {

/// Between a raft and what does not stand on it.
constexpr Coord kClearanceNm = 500'000;

bool SharesRaft(const ObjectPlanOptions& a, const ObjectPlanOptions& b) {
  return a.raft == b.raft && a.raft_settings == b.raft_settings;
}

MultiPolygon Without(const MultiPolygon& region, const MultiPolygon& taken) {
  if (region.empty() || taken.empty() || !Bounds(region).Intersects(Bounds(taken))) return region;
  return Difference(region, taken);
}

MultiPolygon Cleared(const MultiPolygon& region) {
  return Offset(region, kClearanceNm, {.join = Join::kRound});
}

bool Overlap(const RaftLayer& layer, const ObjectSection& other) {
  return layer.print_z_nm - layer.height_nm < other.z_nm &&
         other.z_nm - other.height_nm < layer.print_z_nm;
}

/// How high the rafts of these copies are.
Coord HighestRaft(const PlanningOptions& options, std::span<const PlacedCopy> copies) {
  Coord highest = 0;
  for (const PlacedCopy& copy : copies) {
    const RaftHeights& raft = options.objects[static_cast<size_t>(copy.object)].raft.heights;
    if (raft.layers > 0) highest = std::max(highest, raft.TopOf(raft.layers - 1));
  }
  return highest;
}

}  // namespace

bool RaftPlanner::IsNeeded(const PlanningOptions& options, std::span<const PlacedCopy> copies) {
  return HighestRaft(options, copies) > 0;
}

RaftPlanner::SeenObjects RaftPlanner::LookAt(std::span<const SlicedLayer> parts,
                                             const RegionPlan& plan) const {
  const Coord highest_nm = HighestRaft(options_, copies_);
  SeenObjects objects;
  const auto look = [&](const ObjectSection& section, Coord top_nm) {
    const MultiPolygon& outline = OutlineOf(section);
    if (outline.empty()) return;
    const auto [place, is_new] = objects.try_emplace(section.stack.object);
    Seen& seen = place->second;
    if (is_new) {
      seen.lowest = outline;
    } else if (!section.stack.IsPart() && section.layer == 0 &&
               section.z_nm == section.height_nm) {
      seen.lowest = Union(seen.lowest, outline);
    }
    const Coord lift_nm = OptionsOf(section.stack.object).raft.heights.LiftNm();
    if (lift_nm + top_nm - section.height_nm < highest_nm)
      seen.low = seen.low.empty() ? outline : Union(seen.low, outline);
  };
  for (const SlicedLayer& layer : parts)
    for (const ObjectSection& section : layer.sections) look(section, layer.frame.print_z_nm);
  for (const AddedStack& added : plan.stacks)
    for (const ObjectSection& section : added.sections) look(section, section.z_nm);
  return objects;
}

MultiPolygon RaftPlanner::Carried(const SeenObjects& seen, const ObjectPlanOptions& group) const {
  MultiPolygon carried;
  for (const PlacedCopy& copy : copies_)
    if (const auto found = seen.find(copy.object);
        found != seen.end() && SharesRaft(OptionsOf(copy.object), group))
      Append(Moved(found->second.lowest, copy.shift), carried);
  return United(carried);
}

MultiPolygon RaftPlanner::NotCarried(const SeenObjects& seen,
                                     const ObjectPlanOptions& group) const {
  MultiPolygon others;
  for (const PlacedCopy& copy : copies_)
    if (const auto found = seen.find(copy.object);
        found != seen.end() && !SharesRaft(OptionsOf(copy.object), group))
      Append(Moved(found->second.low, copy.shift), others);
  return Cleared(United(others));
}

std::vector<RaftLayer> RaftPlanner::LayersOf(const SeenObjects& seen,
                                             const ObjectPlanOptions& group,
                                             const RegionPlan& plan) const {
  const MultiPolygon others = NotCarried(seen, group);
  std::vector<RaftLayer> layers = RaftUnder(Carried(seen, group), group.raft);
  for (RaftLayer& layer : layers) {
    layer.region = Without(Intersection(layer.region, {{RoomOf(options_.bed), {}}}), others);
    for (const AddedStack& before : plan.stacks) {
      if (before.stack.kind != StackKind::kRaft) continue;
      for (const ObjectSection& section : before.sections)
        if (Overlap(layer, section) &&
            Bounds(layer.region).Grown(kClearanceNm).Intersects(Bounds(OutlineOf(section))))
          layer.region = Without(layer.region, Cleared(OutlineOf(section)));
    }
  }
  return layers;
}

void RaftPlanner::Lift(RegionPlan& plan) const {
  plan.lifts_nm.assign(options_.objects.size(), 0);
  for (size_t i = 0; i < options_.objects.size(); ++i)
    plan.lifts_nm[i] = options_.objects[i].raft.heights.LiftNm();
}

absl::Status RaftPlanner::Plan(std::span<const SlicedLayer> parts, const CancelToken& cancel,
                               RegionPlan& plan) {
  Lift(plan);
  const SeenObjects objects = LookAt(parts, plan);
  std::vector<const ObjectPlanOptions*> groups;
  for (const auto& [object, seen] : objects) {
    const ObjectPlanOptions& own = OptionsOf(object);
    const bool known = std::ranges::any_of(
        groups, [&](const ObjectPlanOptions* group) { return SharesRaft(*group, own); });
    if (own.raft.heights.layers <= 0 || known) continue;
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    groups.push_back(&own);
    std::vector<RaftLayer> layers = LayersOf(objects, own, plan);
    AddedStack& raft = plan.Add(kPlateObject, StackKind::kRaft);
    for (RaftLayer& layer : layers) {
      ObjectSection& section = raft.sections.emplace_back();
      section.stack = raft.stack;
      section.layer = static_cast<int32_t>(raft.sections.size()) - 1;
      section.layer_count = static_cast<int32_t>(layers.size());
      section.height_nm = layer.height_nm;
      section.z_nm = layer.print_z_nm;
      if (layer.region.empty()) continue;
      const Role role =
          layer.kind == RaftLayerKind::kInterface ? Role::kRaftInterface : Role::kRaft;
      const auto row = own.raft_settings[static_cast<size_t>(section.layer)];
      section.regions.push_back({role, row, 0, std::move(layer.region)});
    }
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::planning
