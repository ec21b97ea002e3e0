#include "services/beading/algo/section_walls.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/model/bead_section.h"
#include "services/beading/algo/arachne/arachne_island.h"
#include "services/beading/algo/classic/classic_island.h"
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

/// Walls of islands by one set of options.
class IslandWaller {
 public:
  static absl::StatusOr<IslandWaller> Make(const SectionPlace& place,
                                           const BeadingOptions& options) {
    const Coord height = place.section.height_nm;
    const Coord external = place.on_bed ? options.first_layer_width_nm : options.external_width_nm;
    const Coord inner = place.on_bed ? options.first_layer_width_nm : options.inner_width_nm;
    if (absl::Status ok = CheckWidths(place.on_bed, external, inner, height); !ok.ok()) return ok;
    IslandWaller waller;
    const bool only_one = place.on_bed && options.one_on_bed;
    const int32_t perimeters = only_one ? std::min(options.perimeters, 1) : options.perimeters;
    waller.plan_ = WallPlan::Make(perimeters, external, inner, height);
    waller.plan_.gap_fill = options.gap_fill;
    waller.plan_.thin_walls = options.thin_walls || options.generator == WallGenerator::kArachne;
    waller.gap_options_ = {options.min_gap_width_nm, options.max_gap_width_nm, height};
    if (options.generator == WallGenerator::kArachne && perimeters > 0)
      waller.UseArachne(place, options);
    return waller;
  }

  absl::StatusOr<IslandBeads> Wall(const PolygonWithHoles& outline, const CancelToken& cancel,
                                   int32_t& plain_islands) const {
    if (arachne_) {
      auto island = arachne_->Make(outline, cancel);
      if (!island.ok()) return island.status();
      if (*island) return **std::move(island);
      ++plain_islands;
    }
    return MakeClassicIsland(outline, plan_, gap_options_, cancel);
  }

 private:
  void UseArachne(const SectionPlace& place, const BeadingOptions& options) {
    const auto band = static_cast<double>(options.transition_deviation_nm);
    arachne_.emplace(options, plan_, gap_options_,
                     [&neighbours = place.neighbours, index = place.index, band](double x, double y,
                                                                                 double radius_nm) {
                       return neighbours.MeanRadius(index, kBeadingHaloLayers, x, y, radius_nm,
                                                    band);
                     });
  }

  WallPlan plan_;
  GapFillOptions gap_options_;
  std::optional<ArachneIslands> arachne_;
};

/// Regions that are walled as one.
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

/// Says of each wall whose it is.
void Sign(const Region& region, std::vector<Path>& walls) {
  for (Path& wall : walls) {
    wall.settings = region.settings;
    wall.tool = region.tool;
    wall.feature = FeatureFor(region.role, wall.feature);
  }
}

}  // namespace

absl::StatusOr<SectionResult> WallSection(const SectionPlace& place,
                                          std::span<const BeadingOptions> regions,
                                          const CancelToken& cancel) {
  const ObjectSection& section = place.section;
  SectionResult result;
  result.walled.object = section.object;
  result.walled.layer = section.layer;
  result.walled.height_nm = section.height_nm;
  for (const Group& group : GroupsOf(section, regions)) {
    const Region& first = *group.front();
    const auto waller = IslandWaller::Make(place, regions[static_cast<size_t>(first.settings)]);
    if (!waller.ok()) return waller.status();
    for (const PolygonWithHoles& outline : OutlinesOf(group, section)) {
      absl::StatusOr<IslandBeads> walls = waller->Wall(outline, cancel, result.plain_islands);
      if (!walls.ok()) return walls.status();
      if (section.object != kPlate) NameRings(OutlineOf(section), walls->walls);
      Sign(first, walls->walls);
      result.walled.islands.push_back(
          {std::move(walls->walls), PartByRegion(std::move(walls->fill_area), group), outline});
    }
  }
  return result;
}

}  // namespace slicefarm::beading
