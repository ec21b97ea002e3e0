#include "services/beading/algo/section_walls.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/bead_section.h"
#include "common/model/options/beading_options.h"
#include "common/model/spiral.h"
#include "services/beading/algo/arachne/arachne_island.h"
#include "services/beading/algo/classic/classic_island.h"
#include "services/beading/algo/extra_walls.h"
#include "services/beading/algo/fuzzy_skin.h"
#include "services/beading/algo/top_walls.h"
#include "services/beading/algo/wall_rings.h"

namespace slicefarm::beading {
namespace {

absl::Status CheckWidths(bool on_bed, Coord external_nm, Coord inner_nm, Coord height_nm) {
  absl::Status status =
      CheckSpacing(on_bed ? "first_layer_extrusion_width" : "external_perimeter_extrusion_width",
                   external_nm, height_nm);
  status.Update(CheckSpacing(on_bed ? "first_layer_extrusion_width" : "perimeter_extrusion_width",
                             inner_nm, height_nm));
  return status;
}

/// Makes walls of islands by one plan, with variable or constant width.
class PlanWaller {
 public:
  /// `deciding_radius`: see VariableWallOptions. `memo` may be null.
  PlanWaller(const WallPlan& plan, const BeadingOptions& options, const GapFillOptions& gap_options,
             IslandMemo::RadiusOf deciding_radius, IslandMemo* memo)
      : plan_(plan),
        options_(options),
        gap_options_(gap_options),
        deciding_radius_(std::move(deciding_radius)),
        memo_(memo) {
    if (options.generator == WallGenerator::kArachne && plan.perimeters > 0)
      arachne_.emplace(options, plan_, gap_options_,
                       memo_ == nullptr ? deciding_radius_ : memo_->Noting(deciding_radius_));
  }

  absl::StatusOr<IslandBeads> Wall(const PolygonWithHoles& outline, const CancelToken& cancel,
                                   int32_t& plain_islands) const {
    if (memo_ == nullptr) return Make(outline, cancel, plain_islands);
    IslandKey key{&options_, plan_, gap_options_.layer_height_nm, outline};
    if (const KnownIsland* known = memo_->Find(key, deciding_radius_)) {
      plain_islands += known->plain_islands;
      return known->beads;
    }
    int32_t plain = 0;
    absl::StatusOr<IslandBeads> beads = Make(outline, cancel, plain);
    if (beads.ok()) memo_->Keep(std::move(key), {*beads, plain});
    plain_islands += plain;
    return beads;
  }

  const WallPlan& plan() const { return plan_; }
  const GapFillOptions& gap_options() const { return gap_options_; }

 private:
  absl::StatusOr<IslandBeads> Make(const PolygonWithHoles& outline, const CancelToken& cancel,
                                   int32_t& plain_islands) const {
    if (arachne_) {
      auto island = arachne_->Make(outline, cancel);
      if (!island.ok()) return island.status();
      if (*island) return **std::move(island);
      ++plain_islands;
    }
    return MakeClassicIsland(outline, plan_, gap_options_, cancel);
  }

  WallPlan plan_;
  const BeadingOptions& options_;
  GapFillOptions gap_options_;
  IslandMemo::RadiusOf deciding_radius_;
  IslandMemo* memo_;
  std::optional<ArachneIslands> arachne_;
};

/// Returns the largest number of walls of an island.
int32_t PerimetersOf(const SectionContext& context, const BeadingOptions& options) {
  const bool topmost = context.section.layer + 1 >= context.section.layer_count;
  const bool only_one = (context.on_bed && options.one_on_bed) ||
                        (topmost && options.one_on_top != OneWallOnTop::kNowhere);
  const bool one_more = options.alternate_extra && context.section.layer % 2 != 0;
  const int32_t perimeters = options.perimeters + (one_more ? 1 : 0);
  return only_one ? std::min(perimeters, 1) : perimeters;
}

/// Makes walls of islands by one set of options. The plan of an island may differ from the usual
/// one, for example by additional walls.
class IslandWaller {
 public:
  static absl::StatusOr<IslandWaller> Make(const SectionContext& context,
                                           const BeadingOptions& options) {
    const Coord height = context.section.height_nm;
    IslandWaller waller(context, options);
    if (absl::Status ok = CheckWidths(context.on_bed, waller.external_, waller.inner_, height);
        !ok.ok())
      return ok;
    waller.FindExposed();
    waller.usual_.emplace(waller.Waller(waller.perimeters_, waller.external_));
    return waller;
  }

  absl::StatusOr<IslandBeads> Wall(const PolygonWithHoles& outline, const CancelToken& cancel,
                                   int32_t& plain_islands) const {
    const int32_t extra = ExtraOf(outline);
    const int32_t perimeters = perimeters_ + extra;
    if (HasTop(outline)) return WallAroundTop(outline, perimeters, cancel, plain_islands);
    if (extra > 0) return Waller(perimeters, external_).Wall(outline, cancel, plain_islands);
    return usual_->Wall(outline, cancel, plain_islands);
  }

 private:
  IslandWaller(const SectionContext& context, const BeadingOptions& options)
      : context_(context),
        options_(options),
        external_(context.on_bed ? options.first_layer_width_nm : options.external_width_nm),
        inner_(context.on_bed ? options.first_layer_width_nm : options.inner_width_nm),
        perimeters_(PerimetersOf(context, options)) {}

  PlanWaller Waller(int32_t perimeters, Coord outermost_nm, bool gap_fill = true,
                    bool inside = false) const {
    WallPlan plan = WallPlan::Make(perimeters, outermost_nm, inner_, context_.section.height_nm);
    if (!inside) plan.apart_nm = Apart();
    if (context_.on_bed) plan.min_bead_nm = options_.first_layer_min_bead_nm;
    plan.min_top_nm = options_.min_top_width_nm;
    plan.gap_fill = options_.gap_fill && gap_fill;
    plan.least_tip_nm = options_.least_tip_nm;
    plan.thin_walls = options_.thin_walls || options_.generator == WallGenerator::kArachne;
    // With gap fill in exposed areas only, walls depend on all of the neighbouring layers.
    IslandMemo* memo = exposed_ ? nullptr : context_.memo;
    return PlanWaller(plan, options_, GapOptions(), DecidingRadius(), memo);
  }

  /// Returns the distance that precise_outer_wall adds between the outermost wall and the next one:
  /// their round sides touch instead of overlapping.
  Coord Apart() const {
    const Coord height = context_.section.height_nm;
    if (!options_.precise_outer) return 0;
    return (external_ - Spacing(external_, height) + inner_ - Spacing(inner_, height)) / 2;
  }

  GapFillOptions GapOptions() const {
    return {.min_width_nm = options_.min_gap_width_nm,
            .max_width_nm = options_.max_gap_width_nm,
            .layer_height_nm = context_.section.height_nm,
            .min_length_nm = options_.min_gap_length_nm,
            .narrow_parts = options_.gap_target != GapFillTarget::kNowhere,
            .among = exposed_ ? exposed_.get() : nullptr};
  }

  /// Finds the areas of the section with nothing above or below them, if gap fill is only for these
  /// areas.
  void FindExposed() {
    const MultiPolygon* below =
        context_.section.layer > 0 ? context_.neighbours.At(context_.index, -1) : nullptr;
    if (options_.gap_target != GapFillTarget::kTopBottom || Above() == nullptr || below == nullptr)
      return;
    exposed_ = std::make_shared<const MultiPolygon>(
        Difference(OutlineOf(context_.section), Intersection(*Above(), *below)));
  }

  /// Returns the outlines of the layer above; nullptr if there is no such layer.
  const MultiPolygon* Above() const { return context_.neighbours.At(context_.index, 1); }

  int32_t ExtraOf(const PolygonWithHoles& outline) const {
    if (!options_.extra_perimeters || perimeters_ != options_.perimeters || Above() == nullptr)
      return 0;
    return ExtraWalls(outline, *Above(), usual_->plan());
  }

  TopParts Parts(const MultiPolygon& inside) const {
    static const MultiPolygon kAir;
    const MultiPolygon* below =
        context_.section.layer > 0 ? context_.neighbours.At(context_.index, -1) : nullptr;
    return PartByTop(inside, Above() == nullptr ? kAir : *Above(), below, usual_->plan());
  }

  /// Returns true if the island has a top surface that inner walls must go around. The area inside
  /// the outermost wall is approximated: the outline inset by the wall's width.
  bool HasTop(const PolygonWithHoles& outline) const {
    return options_.one_on_top == OneWallOnTop::kSurfaces && perimeters_ > 1 &&
           !Parts(FastOffset({outline}, -external_)).top.empty();
  }

  absl::StatusOr<IslandBeads> WallAroundTop(const PolygonWithHoles& outline, int32_t perimeters,
                                            const CancelToken& cancel,
                                            int32_t& plain_islands) const {
    // The area inside the single wall is divided before gaps are searched.
    absl::StatusOr<IslandBeads> island =
        Waller(1, external_, /*gap_fill=*/false).Wall(outline, cancel, plain_islands);
    if (!island.ok()) return island;
    TopParts parts = Parts(island->fill_area);
    island->fill_area = std::move(parts.top);
    const PlanWaller inner_waller =
        Waller(perimeters - 1, inner_, /*gap_fill=*/true, /*inside=*/true);
    if (options_.gap_fill) {
      auto narrow = FillNarrowParts(inner_waller.gap_options(), cancel, island->fill_area);
      if (!narrow.ok()) return narrow.status();
      std::ranges::move(*narrow, std::back_inserter(island->walls));
    }
    // The following beads tile: no space is needed for the round side of an outermost bead.
    const WallPlan& plan = inner_waller.plan();
    const Coord round = (plan.external_width_nm - plan.external_spacing_nm) / 2;
    for (const PolygonWithHoles& rest : FastOffset(parts.covered, round - Apart())) {
      absl::StatusOr<IslandBeads> inner = inner_waller.Wall(rest, cancel, plain_islands);
      if (!inner.ok()) return inner;
      MakeInner(inner->walls);
      std::ranges::move(inner->walls, std::back_inserter(island->walls));
      island->fill_area = Union(island->fill_area, inner->fill_area);
    }
    return island;
  }

  IslandMemo::RadiusOf DecidingRadius() const {
    const auto band = static_cast<double>(options_.transition_deviation_nm);
    return [&neighbours = context_.neighbours, index = context_.index, band](double x, double y,
                                                                             double radius_nm) {
      return neighbours.MeanRadius(index, kBeadingHaloLayers, x, y, radius_nm, band);
    };
  }

  const SectionContext& context_;
  const BeadingOptions& options_;
  Coord external_;
  Coord inner_;
  int32_t perimeters_;
  std::optional<PlanWaller> usual_;
  /// Areas with nothing above or below, for gap fill; null: gap fill is everywhere or nowhere.
  std::shared_ptr<const MultiPolygon> exposed_;
};

/// Regions that share their walls.
using Group = std::vector<const Region*>;

std::vector<Group> GroupsOf(const ObjectSection& section, std::span<const BeadingOptions> regions) {
  const auto key = [&](const Region& region) {
    const int32_t wall_class = regions[static_cast<size_t>(region.settings)].wall_class;
    return std::tuple(region.role, region.tool, wall_class);
  };
  std::vector<Group> groups;
  for (const Region& region : section.regions) {
    const auto same = std::ranges::find_if(
        groups, [&](const Group& group) { return key(*group.front()) == key(region); });
    if (same == groups.end()) {
      groups.push_back({&region});
    } else {
      same->push_back(&region);
    }
  }
  return groups;
}

MultiPolygon OutlinesOf(const Group& group, const ObjectSection& section) {
  if (group.size() == section.regions.size()) return OutlineOf(section);
  if (group.size() == 1) return group.front()->outlines;
  std::vector<Polygon> rings;
  for (const Region* region : group) {
    std::vector<Polygon> own = Rings(region->outlines);
    std::ranges::move(own, std::back_inserter(rings));
  }
  return Union(rings, FillRule::kNonZero);
}

std::vector<FillArea> PartByRegion(MultiPolygon area, const Group& group) {
  std::vector<FillArea> areas;
  if (area.empty()) return areas;
  for (const Region* region : group) {
    MultiPolygon own = group.size() == 1 ? std::move(area) : Intersection(area, region->outlines);
    if (own.empty()) continue;
    areas.push_back({region->role, region->settings, region->tool, std::move(own)});
  }
  return areas;
}

/// Returns the walls of an island. An island of a hollow section has one wall along its outline and
/// nothing inside.
absl::StatusOr<IslandBeads> WallsOf(const PolygonWithHoles& outline, const SectionContext& context,
                                    const IslandWaller& waller, const BeadingOptions& options,
                                    const CancelToken& cancel, int32_t& plain_islands) {
  if (!context.section.hollow) return waller.Wall(outline, cancel, plain_islands);
  if (std::optional<Polygon> loop = SpiralLoop({outline}, options.external_width_nm)) {
    IslandBeads turn;
    turn.walls.push_back({.feature = Feature::kExternalPerimeter,
                          .closed = true,
                          .points = *std::move(loop),
                          .widths_nm = {options.external_width_nm}});
    return turn;
  }
  absl::StatusOr<IslandBeads> island = waller.Wall(outline, cancel, plain_islands);
  if (island.ok()) island->fill_area.clear();
  return island;
}

/// Removes open lines between walls that are too short to be worth a travel. Lines of the lowest
/// and the highest layer stay, because they are visible.
void RemoveShortLines(const ObjectSection& section, const BeadingOptions& options,
                      std::vector<Path>& walls) {
  const double least = options.min_length_factor * static_cast<double>(options.external_width_nm);
  if (least <= 0 || section.layer == 0 || section.layer + 1 >= section.layer_count) return;
  std::erase_if(walls,
                [least](const Path& wall) { return !wall.closed && PathLength(wall) < least; });
}

/// Sets the settings, tool and feature of a region on its walls.
void Sign(const Region& region, std::vector<Path>& walls) {
  for (Path& wall : walls) {
    wall.settings = region.settings;
    wall.tool = region.tool;
    wall.feature = FeatureFor(region.role, wall.feature);
  }
}

}  // namespace

absl::StatusOr<SectionResult> WallSection(const SectionContext& context,
                                          std::span<const BeadingOptions> regions,
                                          const CancelToken& cancel) {
  const ObjectSection& section = context.section;
  SectionResult result;
  result.walled.stack = section.stack;
  result.walled.layer = section.layer;
  result.walled.height_nm = section.height_nm;
  for (const Group& group : GroupsOf(section, regions)) {
    const Region& first = *group.front();
    const BeadingOptions& options = regions[static_cast<size_t>(first.settings)];
    const auto waller = IslandWaller::Make(context, options);
    if (!waller.ok()) return waller.status();
    for (const PolygonWithHoles& outline : OutlinesOf(group, section)) {
      absl::StatusOr<IslandBeads> walls =
          WallsOf(outline, context, *waller, options, cancel, result.plain_islands);
      if (!walls.ok()) return walls.status();
      if (section.stack.IsPart()) {
        if (options.generator == WallGenerator::kArachne)
          RemoveShortLines(section, options, walls->walls);
        NameRings(OutlineOf(section), walls->walls);
        Roughen(options, {section.stack.object, section.layer, section.z_nm, section.height_nm},
                walls->walls);
      }
      Sign(first, walls->walls);
      result.walled.islands.push_back(
          {std::move(walls->walls), PartByRegion(std::move(walls->fill_area), group), outline});
    }
  }
  return result;
}

}  // namespace slicefarm::beading
