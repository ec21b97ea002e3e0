#include "services/planning/algo/adhesion/raft_planner.h"

#include <algorithm>
#include <utility>

#include "common/geometry/moved.h"
#include "common/geometry/offset/offset.h"
#include "services/planning/algo/adhesion/alone.h"
#include "services/planning/algo/adhesion/printable_area.h"

namespace slicefarm::planning {
namespace {

/// Clearance between a raft and the objects that are not on it.
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

/// Returns the height of the highest raft of these copies.
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
    } else if (!section.stack.IsPart() && section.layer == 0 && section.z_nm == section.height_nm) {
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

MultiPolygon RaftPlanner::AboveRaft(const SeenObjects& seen, const ObjectPlanOptions& group) const {
  MultiPolygon above;
  for (const PlacedCopy& copy : copies_)
    if (const auto found = seen.find(copy.object);
        found != seen.end() && SharesRaft(OptionsOf(copy.object), group))
      Append(Moved(found->second.lowest, copy.shift), above);
  return United(above);
}

MultiPolygon RaftPlanner::BesideRaft(const SeenObjects& seen,
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
  const MultiPolygon others = BesideRaft(seen, group);
  std::vector<RaftLayer> layers = RaftUnder(AboveRaft(seen, group), group.raft);
  for (RaftLayer& layer : layers) {
    layer.region = Without(Intersection(layer.region, PrintableArea(options_.bed)), others);
    for (const AddedStack& before : plan.stacks) {
      if (before.stack.kind != StackKind::kRaft || before.stack.object != kPlateObject) continue;
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
  // Supports rest directly on the raft. They are never separated from the raft, so they need no
  // gap.
  for (AddedStack& added : plan.stacks) {
    if (added.stack.kind != StackKind::kSupport) continue;
    added.lift_nm = plan.lifts_nm[static_cast<size_t>(added.stack.object)];
    const RaftHeights& raft = OptionsOf(added.stack.object).raft.heights;
    if (raft.layers <= 0) continue;
    for (ObjectSection& section : added.sections)
      if (section.z_nm == section.height_nm) section.height_nm += raft.contact_distance_nm;
  }
}

std::set<int32_t> RaftPlanner::Alone(const SeenObjects& seen) const {
  if (options_.sequence.complete_objects) return {};
  std::vector<CopyFootprint> footprints;
  for (const PlacedCopy& copy : copies_) {
    const auto found = seen.find(copy.object);
    if (found == seen.end()) continue;
    const RaftOptions& raft = OptionsOf(copy.object).raft;
    const bool has_raft = raft.heights.layers > 0;
    const Coord reach_nm =
        has_raft ? raft.expansion_nm + std::max(kRaftStepNm, raft.first_layer_expansion_nm) : 0;
    const Box box = Bounds(has_raft ? found->second.lowest : found->second.low);
    if (box.Empty()) continue;
    const Box footprint = box.Grown(reach_nm + kClearanceNm / 2);
    footprints.push_back({copy.object, {footprint.min + copy.shift, footprint.max + copy.shift}});
  }
  return ObjectsAlone(footprints, PrintableArea(options_.bed));
}

void RaftPlanner::AddRaft(int32_t object, const ObjectPlanOptions& options,
                          std::vector<RaftLayer> layers, RegionPlan& plan) const {
  AddedStack& raft = plan.Add(object, StackKind::kRaft);
  for (RaftLayer& layer : layers) {
    ObjectSection& section = raft.sections.emplace_back();
    section.stack = raft.stack;
    section.layer = static_cast<int32_t>(raft.sections.size()) - 1;
    section.layer_count = static_cast<int32_t>(layers.size());
    section.height_nm = layer.height_nm;
    section.z_nm = layer.print_z_nm;
    if (layer.region.empty()) continue;
    const Role role = layer.kind == RaftLayerKind::kInterface ? Role::kRaftInterface : Role::kRaft;
    const auto row = options.raft_settings[static_cast<size_t>(section.layer)];
    section.regions.push_back({role, row, 0, std::move(layer.region)});
  }
}

absl::Status RaftPlanner::Plan(std::span<const SlicedLayer> parts, const CancelToken& cancel,
                               RegionPlan& plan) {
  SeenObjects objects = LookAt(parts, plan);
  Lift(plan);
  for (const int32_t object : Alone(objects)) {
    const ObjectPlanOptions& own = OptionsOf(object);
    if (own.raft.heights.layers <= 0) continue;
    AddRaft(object, own, RaftUnder(United(objects.at(object).lowest), own.raft), plan);
    objects.erase(object);
  }
  std::vector<const ObjectPlanOptions*> groups;
  for (const auto& [object, seen] : objects) {
    const ObjectPlanOptions& own = OptionsOf(object);
    const bool known = std::ranges::any_of(
        groups, [&](const ObjectPlanOptions* group) { return SharesRaft(*group, own); });
    if (own.raft.heights.layers <= 0 || known) continue;
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    groups.push_back(&own);
    AddRaft(kPlateObject, own, LayersOf(objects, own, plan), plan);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::planning
