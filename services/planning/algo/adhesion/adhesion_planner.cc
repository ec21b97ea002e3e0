#include "services/planning/algo/adhesion/adhesion_planner.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "common/base/error.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/moved.h"
#include "common/geometry/offset/offset.h"
#include "common/model/limits.h"
#include "services/planning/algo/adhesion/automatic_brim.h"
#include "services/planning/algo/adhesion/brim.h"
#include "services/planning/algo/adhesion/skirt.h"

namespace slicefarm::planning {
namespace {

/// Between a raft and what does not stand on it.
constexpr Coord kRaftClearanceNm = 500'000;
constexpr int64_t kMaxSkirtPoints = 20'000'000;

/// The bed, or all that has coordinates.
Polygon RoomOf(const Polygon& bed) {
  constexpr Coord kMost = limits::kMaxCoord;
  if (!bed.empty()) return bed;
  return {{-kMost, -kMost}, {kMost, -kMost}, {kMost, kMost}, {-kMost, kMost}};
}

void Append(MultiPolygon more, MultiPolygon& all) {
  std::ranges::move(more, std::back_inserter(all));
}

MultiPolygon United(const MultiPolygon& all) { return Union(all, {}); }

/// Regions that border on each other as one.
MultiPolygon Joined(const MultiPolygon& regions) { return OffsetTwice(regions, kGlueNm, -kGlueNm); }

bool SharesRaft(const ObjectPlanOptions& a, const ObjectPlanOptions& b) {
  return a.raft == b.raft && a.raft_settings == b.raft_settings;
}

bool Overlap(const RaftLayer& a, const RaftLayer& b) {
  return a.print_z_nm - a.height_nm < b.print_z_nm && b.print_z_nm - b.height_nm < a.print_z_nm;
}

MultiPolygon Without(const MultiPolygon& region, const MultiPolygon& taken) {
  if (region.empty() || taken.empty() || !Bounds(region).Intersects(Bounds(taken))) return region;
  return Difference(region, taken);
}

MultiPolygon Cleared(const MultiPolygon& region) {
  return Offset(region, kRaftClearanceNm, {.join = Join::kRound});
}

}  // namespace

AdhesionPlanner::AdhesionPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies)
    : options_(options),
      copies_(copies),
      bed_(RoomOf(options.bed)),
      highest_raft_nm_(HighestRaft()),
      wanted_(options.skirt.loops > 0 || highest_raft_nm_ > 0 ||
              std::ranges::any_of(
                  copies, [this](const PlacedCopy& copy) { return HasBrim(copy.object); })) {}

bool AdhesionPlanner::HasRaft(int32_t object) const {
  return options_.objects[static_cast<size_t>(object)].raft.heights.layers > 0;
}

bool AdhesionPlanner::HasBrim(int32_t object) const {
  const BrimOptions& brim = options_.objects[static_cast<size_t>(object)].brim;
  return brim.type != BrimType::kNone && (brim.automatic.on || brim.width_nm > 0) &&
         !HasRaft(object);
}

Coord AdhesionPlanner::HighestRaft() const {
  Coord highest = 0;
  for (const PlacedCopy& copy : copies_) {
    const RaftHeights& raft = options_.objects[static_cast<size_t>(copy.object)].raft.heights;
    if (raft.layers > 0) highest = std::max(highest, raft.TopOf(raft.layers - 1));
  }
  return highest;
}

void AdhesionPlanner::Look(const SlicedLayer& layer, LayerPlan&) {
  if (!wanted_) return;
  const LayerFrame& frame = layer.frame;
  if (frame.index == 0) first_height_nm_ = frame.height_nm;
  if (frame.print_z_nm <= highest_raft_nm_) layer_at_[frame.print_z_nm] = frame.index;
  for (const ObjectSection& section : layer.sections) {
    if (OutlineOf(section).empty()) continue;
    layers_ = frame.index + 1;
    LookAt(layer, section);
  }
}

void AdhesionPlanner::LookAt(const SlicedLayer& layer, const ObjectSection& section) {
  const MultiPolygon& outline = OutlineOf(section);
  const LayerFrame& frame = layer.frame;
  const auto [place, is_new] = seen_.try_emplace(section.object);
  Seen& seen = place->second;
  seen.height_nm = section.z_nm;
  if (is_new) {
    seen.first = outline;
    seen.on_bed = frame.index == 0;
  }
  if (frame.print_z_nm - section.height_nm < highest_raft_nm_)
    seen.low = seen.low.empty() ? outline : Union(seen.low, outline);
  if (frame.index < SkirtLayers(options_.skirt, frame.index + 1)) {
    for (const PolygonWithHoles& island : outline)
      seen.hull.insert(seen.hull.end(), island.outer.begin(), island.outer.end());
    seen.hull = ConvexHull(std::move(seen.hull));
  }
}

MultiPolygon AdhesionPlanner::Carried(const ObjectPlanOptions& group) const {
  MultiPolygon carried;
  for (const PlacedCopy& copy : copies_) {
    const auto seen = seen_.find(copy.object);
    if (seen != seen_.end() &&
        SharesRaft(options_.objects[static_cast<size_t>(copy.object)], group))
      Append(Moved(seen->second.first, copy.shift), carried);
  }
  return United(carried);
}

MultiPolygon AdhesionPlanner::NotCarried(const ObjectPlanOptions& group) const {
  MultiPolygon others;
  for (const PlacedCopy& copy : copies_) {
    const auto seen = seen_.find(copy.object);
    if (seen != seen_.end() &&
        !SharesRaft(options_.objects[static_cast<size_t>(copy.object)], group))
      Append(Moved(seen->second.low, copy.shift), others);
  }
  return Cleared(United(others));
}

absl::StatusOr<std::vector<AdhesionPlanner::PlacedLayer>> AdhesionPlanner::PlaceRafts(
    const CancelToken& cancel) const {
  std::vector<PlacedLayer> placed;
  std::vector<const ObjectPlanOptions*> groups;
  for (const auto& [object, seen] : seen_) {
    const ObjectPlanOptions& own = options_.objects[static_cast<size_t>(object)];
    const bool known = std::ranges::any_of(
        groups, [&](const ObjectPlanOptions* group) { return SharesRaft(*group, own); });
    if (!HasRaft(object) || known) continue;
    if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
    groups.push_back(&own);
    const MultiPolygon others = NotCarried(own);
    const size_t before = placed.size();
    for (RaftLayer& layer : RaftUnder(Carried(own), own.raft)) {
      layer.region = Without(Intersection(layer.region, {{bed_, {}}}), others);
      for (size_t i = 0; i < before; ++i)
        if (Overlap(layer, placed[i].layer) &&
            Bounds(layer.region).Grown(kRaftClearanceNm).Intersects(Bounds(placed[i].layer.region)))
          layer.region = Without(layer.region, Cleared(placed[i].layer.region));
      const auto index = placed.size() - before;
      placed.push_back({std::move(layer), own.raft_settings[index]});
    }
  }
  return placed;
}

absl::StatusOr<std::vector<Region>> AdhesionPlanner::PlaceBrims(std::span<const PlacedLayer> rafts,
                                                                const MultiPolygon& shield,
                                                                const CancelToken& cancel) const {
  if (std::ranges::none_of(copies_,
                           [this](const PlacedCopy& copy) { return HasBrim(copy.object); }))
    return std::vector<Region>();
  std::vector<BrimObject> objects;
  std::vector<int32_t> rows;
  for (const PlacedCopy& copy : copies_) {
    const auto seen = seen_.find(copy.object);
    if (seen == seen_.end() || !seen->second.on_bed || HasRaft(copy.object)) continue;
    const ObjectPlanOptions& own = options_.objects[static_cast<size_t>(copy.object)];
    BrimOptions brim = own.brim;
    if (brim.automatic.on)
      brim.width_nm =
          AutomaticBrimWidth(brim.automatic, seen->second.first, seen->second.height_nm);
    objects.push_back({Moved(seen->second.first, copy.shift), brim});
    rows.push_back(own.brim_settings);
  }
  for (const PlacedLayer& raft : rafts)
    if (raft.layer.print_z_nm == raft.layer.height_nm) objects.push_back({raft.layer.region, {}});
  if (!shield.empty()) objects.push_back({shield, {}});

  absl::StatusOr<std::vector<MultiPolygon>> brims = BrimRegions(objects, bed_, cancel);
  if (!brims.ok()) return brims.status();
  std::map<int32_t, MultiPolygon> by_row;
  for (size_t i = 0; i < rows.size(); ++i) Append(std::move((*brims)[i]), by_row[rows[i]]);
  std::vector<Region> regions;
  for (const auto& [row, pieces] : by_row)
    if (!pieces.empty()) regions.push_back({Role::kBrim, row, 0, Joined(pieces)});
  return regions;
}

MultiPolygon AdhesionPlanner::Fenced(std::span<const PlacedLayer> rafts) const {
  MultiPolygon fenced;
  for (const PlacedCopy& copy : copies_) {
    const auto seen = seen_.find(copy.object);
    if (seen == seen_.end() || seen->second.hull.size() < 3) continue;
    fenced.push_back({Moved(seen->second.hull, copy.shift), {}});
  }
  for (const PlacedLayer& raft : rafts)
    if (layer_at_.at(raft.layer.print_z_nm) < SkirtLayers(options_.skirt, layers_))
      Append(raft.layer.region, fenced);
  return fenced;
}

void AdhesionPlanner::AddRafts(std::vector<PlacedLayer> rafts, JobPlan& plan) const {
  for (PlacedLayer& raft : rafts) {
    if (raft.layer.region.empty()) continue;
    const int32_t index = layer_at_.at(raft.layer.print_z_nm);
    const auto same = std::ranges::find_if(plan.additions, [&](const PlateAddition& addition) {
      return addition.layer == index && addition.height_nm == raft.layer.height_nm;
    });
    PlateAddition& addition =
        same != plan.additions.end()
            ? *same
            : plan.additions.emplace_back(PlateAddition{index, raft.layer.height_nm, {}, {}});
    const Role role =
        raft.layer.kind == RaftLayerKind::kInterface ? Role::kRaftInterface : Role::kRaft;
    addition.regions.push_back({role, raft.settings, 0, std::move(raft.layer.region)});
  }
}

absl::Status AdhesionPlanner::AddSkirt(std::vector<Path> loops, JobPlan& plan) const {
  if (loops.empty()) return absl::OkStatus();
  int64_t points = 0;
  for (Path& loop : loops) {
    loop.settings = options_.skirt_settings;
    points += std::ssize(loop.points);
  }
  const int32_t layers = SkirtLayers(options_.skirt, layers_);
  if (points * layers > kMaxSkirtPoints)
    return LimitError(Reason::kRequestTooLarge, "points of the skirt on all layers",
                      kMaxSkirtPoints, points * layers);
  for (int32_t layer = 0; layer < layers; ++layer)
    plan.additions.push_back({layer, options_.skirt.height_nm, {}, loops});
  return absl::OkStatus();
}

absl::Status AdhesionPlanner::Finish(const CancelToken& cancel, OpenLayers& /*layers*/,
                                     JobPlan& plan) {
  if (!wanted_) return absl::OkStatus();
  absl::StatusOr<std::vector<PlacedLayer>> placed = PlaceRafts(cancel);
  if (!placed.ok()) return placed.status();
  std::vector<PlacedLayer> rafts = *std::move(placed);
  for (const PlacedLayer& raft : rafts)
    if (!layer_at_.contains(raft.layer.print_z_nm))
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                       fmt::format("no layer ends {} nm above the bed, where a raft's does",
                                   raft.layer.print_z_nm),
                       {{"field", "raft"}});
  const SkirtOptions& skirt = options_.skirt;
  const MultiPolygon fenced = skirt.loops > 0 ? Fenced(rafts) : MultiPolygon{};
  const bool shields = skirt.draft_shield != DraftShield::kDisabled;
  std::vector<Path> loops;
  if (shields) loops = SkirtLoops(fenced, {}, skirt);
  auto brims = PlaceBrims(rafts, ShieldKeepOut(loops, skirt), cancel);
  if (!brims.ok()) return brims.status();
  if (!shields) {
    MultiPolygon outside;
    for (const Region& brim : *brims) Append(brim.outlines, outside);
    loops = SkirtLoops(fenced, outside, skirt);
  }
  if (absl::Status ok = AddSkirt(WithinBed(std::move(loops), bed_), plan); !ok.ok()) return ok;
  if (!brims->empty()) plan.additions.push_back({0, first_height_nm_, *std::move(brims), {}});
  AddRafts(std::move(rafts), plan);
  std::ranges::stable_sort(plan.additions, {}, &PlateAddition::layer);
  return absl::OkStatus();
}

}  // namespace slicefarm::planning
