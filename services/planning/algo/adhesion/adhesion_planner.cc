#include "services/planning/algo/adhesion/adhesion_planner.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/base/error.h"
#include "common/base/shared/shared_text.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/offset.h"
#include "common/model/limits.h"
#include "common/model/options/planning_options.h"
#include "services/planning/algo/adhesion/alone.h"
#include "services/planning/algo/adhesion/automatic_brim.h"
#include "services/planning/algo/adhesion/brim.h"
#include "services/planning/algo/adhesion/printable_area.h"

namespace slicefarm::planning {
namespace {

constexpr int64_t kMaxSkirtPoints = 20'000'000;

/// Merges regions that share a border.
MultiPolygon Joined(const MultiPolygon& regions) { return OffsetTwice(regions, kGlueNm, -kGlueNm); }

/// Returns the lines of the innermost loop that is not completely outside of the bed. `loops`: the
/// outermost first.
std::vector<Path> InnermostWithinBed(const std::vector<Path>& loops, const MultiPolygon& bed) {
  std::vector<Path> lines;
  for (auto loop = loops.rbegin(); loop != loops.rend() && lines.empty(); ++loop)
    lines = WithinBed({*loop}, bed);
  return lines;
}

/// Merges the regions of the plate's brims. The regions are disjoint, because brims of different
/// objects do not overlap.
MultiPolygon WholeOf(const std::vector<Region>& regions) {
  MultiPolygon all;
  for (const Region& region : regions) Append(region.outlines, all);
  return United(all);
}

}  // namespace

AdhesionPlanner::AdhesionPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies)
    : options_(options),
      copies_(copies),
      bed_(PrintableArea(options.bed)),
      wanted_(options.skirt.loops > 0 ||
              std::ranges::any_of(copies,
                                  [this](const PlacedCopy& copy) { return HasBrim(copy.object); })),
      skirt_reach_(options.skirt) {}

bool AdhesionPlanner::HasRaft(int32_t object) const {
  return options_.objects[static_cast<size_t>(object)].raft.heights.layers > 0;
}

bool AdhesionPlanner::HasBrim(int32_t object) const {
  const BrimOptions& brim = options_.objects[static_cast<size_t>(object)].brim;
  return brim.type != BrimType::kNone && (brim.automatic.on || brim.width_nm > 0) &&
         !HasRaft(object);
}

void AdhesionPlanner::Look(const SlicedLayer& layer, LayerPlan&) {
  if (!wanted_) return;
  const LayerFrame& frame = layer.frame;
  if (frame.index == 0) first_height_nm_ = frame.height_nm;
  const bool in_skirt = skirt_reach_.Next(layer);
  for (const ObjectSection& section : layer.sections) {
    if (OutlineOf(section).empty()) continue;
    if (section.stack.IsPart()) layers_ = skirt_reach_.layers();
    LookAt(layer, section, in_skirt);
  }
}

void AdhesionPlanner::LookAt(const SlicedLayer& layer, const ObjectSection& section,
                             bool in_skirt) {
  const MultiPolygon& outline = OutlineOf(section);
  const LayerFrame& frame = layer.frame;
  Seen& seen = seen_[section.stack.object];
  if (section.stack.IsPart()) seen.height_nm = section.z_nm;
  if (frame.index == 0) {
    MultiPolygon& own = section.stack.kind == StackKind::kRaft ? seen.raft : seen.on_bed;
    own = own.empty() ? outline : Union(own, outline);
  }
  if (in_skirt) {
    for (const PolygonWithHoles& island : outline)
      seen.hull.insert(seen.hull.end(), island.outer.begin(), island.outer.end());
    seen.hull = ConvexHull(std::move(seen.hull));
  }
}

MultiPolygon AdhesionPlanner::OnPlate(MultiPolygon Seen::*of) const {
  MultiPolygon all;
  for (const PlacedCopy& copy : copies_)
    if (const auto seen = seen_.find(copy.object); seen != seen_.end())
      Append(Moved(seen->second.*of, copy.shift), all);
  if (const auto plate = seen_.find(kPlateObject); plate != seen_.end())
    Append(plate->second.*of, all);
  return all;
}

BrimOptions AdhesionPlanner::BrimOf(int32_t object, const Seen& seen) const {
  BrimOptions brim = options_.objects[static_cast<size_t>(object)].brim;
  if (brim.automatic.on)
    brim.width_nm = AutomaticBrimWidth(brim.automatic, seen.on_bed, seen.height_nm);
  if (!brim.compensated) brim.separation_nm += brim.foot_nm;
  return brim;
}

std::set<int32_t> AdhesionPlanner::Alone() const {
  const bool shields =
      options_.skirt.loops > 0 && options_.skirt.draft_shield != DraftShield::kDisabled;
  if (options_.sequence.complete_objects || shields) return {};
  std::vector<CopyFootprint> footprints;
  const auto add = [&](int32_t object, Point shift) {
    const auto found = seen_.find(object);
    if (found == seen_.end()) return;
    const Seen& seen = found->second;
    Coord reach_nm = 0;
    if (object != kPlateObject && HasBrim(object)) {
      const BrimOptions brim = BrimOf(object, seen);
      reach_nm = brim.separation_nm + brim.width_nm;
    }
    Box box = Bounds(seen.on_bed);
    box.Add(Bounds(seen.raft));
    if (box.Empty()) return;
    const Box footprint = box.Grown(reach_nm + kGlueNm);
    footprints.push_back({object, {footprint.min + shift, footprint.max + shift}});
  };
  for (const PlacedCopy& copy : copies_) add(copy.object, copy.shift);
  add(kPlateObject, {});
  std::set<int32_t> alone = ObjectsAlone(footprints, bed_);
  std::erase_if(alone,
                [this](int32_t object) { return object == kPlateObject || !HasBrim(object); });
  return alone;
}

absl::StatusOr<MultiPolygon> AdhesionPlanner::OwnBrim(int32_t object,
                                                      const CancelToken& cancel) const {
  const Seen& seen = seen_.at(object);
  const BrimObject one = {seen.on_bed, BrimOf(object, seen)};
  auto brims = BrimRegions({&one, 1}, PrintableArea({}), cancel);
  if (!brims.ok()) return brims.status();
  return brims->front().empty() ? MultiPolygon{} : Joined(brims->front());
}

absl::StatusOr<std::vector<Region>> AdhesionPlanner::PlaceBrims(const std::set<int32_t>& alone,
                                                                const MultiPolygon& shield,
                                                                const CancelToken& cancel) const {
  if (std::ranges::none_of(copies_,
                           [this](const PlacedCopy& copy) { return HasBrim(copy.object); }))
    return std::vector<Region>();
  std::vector<BrimObject> objects;
  std::vector<int32_t> rows;
  for (const PlacedCopy& copy : copies_) {
    const auto seen = seen_.find(copy.object);
    if (seen == seen_.end() || seen->second.on_bed.empty() || HasRaft(copy.object)) continue;
    if (alone.contains(copy.object)) continue;
    const ObjectPlanOptions& own = options_.objects[static_cast<size_t>(copy.object)];
    objects.push_back({Moved(seen->second.on_bed, copy.shift), BrimOf(copy.object, seen->second)});
    rows.push_back(own.brim_settings);
  }
  if (MultiPolygon rafts = OnPlate(&Seen::raft); !rafts.empty())
    objects.push_back({std::move(rafts), {}});
  if (!shield.empty()) objects.push_back({shield, {}});

  absl::StatusOr<std::vector<MultiPolygon>> brims = BrimRegions(objects, bed_, cancel);
  if (!brims.ok()) return brims.status();
  // A region has the brims of all objects with equal settings, or the brim of one copy.
  std::map<std::pair<int32_t, size_t>, MultiPolygon> joined;
  for (size_t i = 0; i < rows.size(); ++i)
    Append(std::move((*brims)[i]), joined[{rows[i], options_.combine_brims ? 0 : i}]);
  std::vector<Region> regions;
  for (const auto& [of, pieces] : joined)
    if (!pieces.empty()) regions.push_back({Role::kBrim, of.first, 0, Joined(pieces)});
  return regions;
}

MultiPolygon AdhesionPlanner::Fenced() const {
  MultiPolygon fenced;
  const auto add = [&](int32_t object, Point shift) {
    const auto seen = seen_.find(object);
    if (seen == seen_.end() || seen->second.hull.size() < 3) return;
    fenced.push_back({Moved(seen->second.hull, shift), {}});
  };
  for (const PlacedCopy& copy : copies_) add(copy.object, copy.shift);
  add(kPlateObject, {});
  return fenced;
}

void AdhesionPlanner::AddBrim(int32_t object, std::vector<Region> brims, JobPlan& plan) const {
  if (brims.empty()) return;
  const auto id = static_cast<int32_t>(options_.objects.size() + plan.stacks.size());
  AddedStack& added = plan.stacks.emplace_back();
  added.stack = Stack(id, object, StackKind::kBrim);
  ObjectSection& section = added.sections.emplace_back();
  section.stack = added.stack;
  section.height_nm = section.z_nm = first_height_nm_;
  section.regions = std::move(brims);
  if (section.regions.size() > 1) section.whole = WholeOf(section.regions);
}

absl::Status AdhesionPlanner::AddSkirts(std::vector<std::vector<Path>> skirts,
                                        JobPlan& plan) const {
  Skirt skirt;
  for (std::vector<Path>& loops : skirts) {
    for (Path& loop : loops) loop.settings = options_.skirt_settings;
    if (options_.skirt.single_upper)
      std::ranges::move(InnermostWithinBed(loops, bed_), std::back_inserter(skirt.upper_loops));
    std::ranges::move(WithinBed(std::move(loops), bed_), std::back_inserter(skirt.loops));
  }
  if (skirt.loops.empty()) return absl::OkStatus();
  int64_t points = 0;
  for (const Path& loop : skirt.loops) points += std::ssize(loop.points);
  skirt.layers = SkirtLayers(options_.skirt, layers_);
  if (points * skirt.layers > kMaxSkirtPoints)
    return LimitError(Reason::kRequestTooLarge, "points of the skirt on all layers",
                      kMaxSkirtPoints, points * skirt.layers);
  plan.skirt = std::move(skirt);
  return absl::OkStatus();
}

absl::Status AdhesionPlanner::Finish(const CancelToken& cancel, OpenLayers& /*layers*/,
                                     JobPlan& plan) {
  if (!wanted_) return absl::OkStatus();
  const SkirtOptions& skirt = options_.skirt;
  const MultiPolygon fenced = skirt.loops > 0 ? Fenced() : MultiPolygon{};
  const bool shields = skirt.draft_shield != DraftShield::kDisabled;
  std::vector<std::vector<Path>> skirts;
  if (shields) skirts = SkirtLoops(fenced, {}, skirt, cancel);
  const std::set<int32_t> alone = Alone();
  auto brims = PlaceBrims(alone, ShieldKeepOut(skirts, skirt), cancel);
  if (!brims.ok()) return brims.status();
  MultiPolygon outside;  // outlines of all brims
  for (const Region& brim : *brims) Append(brim.outlines, outside);
  for (const int32_t object : alone) {
    absl::StatusOr<MultiPolygon> brim = OwnBrim(object, cancel);
    if (!brim.ok()) return brim.status();
    if (brim->empty()) continue;
    for (const PlacedCopy& copy : copies_)
      if (copy.object == object) Append(Moved(*brim, copy.shift), outside);
    const int32_t row = options_.objects[static_cast<size_t>(object)].brim_settings;
    AddBrim(object, {{Role::kBrim, row, 0, *std::move(brim)}}, plan);
  }
  if (!shields) skirts = SkirtLoops(fenced, outside, skirt, cancel);
  if (absl::Status ok = cancel.Check(); !ok.ok()) return ok;
  if (absl::Status ok = AddSkirts(std::move(skirts), plan); !ok.ok()) return ok;
  AddBrim(kPlateObject, *std::move(brims), plan);
  return absl::OkStatus();
}

}  // namespace slicefarm::planning
