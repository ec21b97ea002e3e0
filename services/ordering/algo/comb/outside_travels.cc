#include "services/ordering/algo/comb/outside_travels.h"

#include <cmath>
#include <utility>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "services/ordering/algo/comb/detour.h"
#include "services/ordering/algo/comb/island_edges.h"

namespace slicefarm::ordering {
namespace {

/// Width in nm of the free space around all islands that detours may use.
constexpr Coord kMargin = 5 * kNmPerMm;
/// Clearance between travels and the islands' outlines, in radii of the outer walls.
constexpr double kClearance = 0.6;

}  // namespace

OutsideTravels::OutsideTravels(const FilledSection& section, const TravelOptions& options)
    : section_(section), options_(options) {
  const auto is_known = [](const FilledIsland& island) { return !island.outline.outer.empty(); };
  if (!options.avoid_crossing || std::ranges::count_if(section.islands, is_known) < 2) return;
  std::vector<Path> outer;
  for (const FilledIsland& island : section.islands)
    for (const Path& wall : island.walls)
      if (IsOuterWall(wall)) outer.push_back(wall);
  for (const Path& wall : outer)
    wall.closed ? walls_.AddRing(wall.points) : walls_.AddLine(wall.points);
  walls_.Build();
  wall_radius_nm_ = OuterWallRadius(outer);
}

Travel OutsideTravels::Between(const Path& last, const Path& next, WorkBudget& budget) {
  if (wall_radius_nm_ == 0 || !IsOuterWall(last) || !IsOuterWall(next)) return {};
  const Point from = EndOf(last), to = StartOf(next);
  if (!walls_.Crosses(from, to)) return {};
  auto corners = Routes().Find(from, to, LongestDetour(from, to, options_), budget);
  return {false, std::move(corners).value_or(std::vector<Point>{})};
}

TravelPaths& OutsideTravels::Routes() {
  if (paths_) return *paths_;
  MultiPolygon islands;
  for (const FilledIsland& island : section_.islands)
    if (!island.outline.outer.empty()) islands.push_back(island.outline);
  const MultiPolygon around = RegionOf(Bounds(islands).Grown(kMargin));
  paths_.emplace(Difference(around, islands),
                 std::llround(kClearance * static_cast<double>(wall_radius_nm_)));
  return *paths_;
}

}  // namespace slicefarm::ordering
