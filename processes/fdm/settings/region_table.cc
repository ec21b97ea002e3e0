#include "processes/fdm/settings/region_table.h"

#include <algorithm>

namespace slicefarm::config::fdm {
namespace {

/// Returns true if walls, or the scarfs and gaps between them, are printed as this feature.
bool IsOfWalls(Feature feature) {
  return feature == Feature::kExternalPerimeter || feature == Feature::kPerimeter ||
         feature == Feature::kOverhangPerimeter || feature == Feature::kGapFill;
}

/// Returns the row with default values for all members that do not affect walls.
RegionRow WallsOf(const RegionRow& region) {
  RegionRow walls = region;
  walls.walls.wall_class = 0;
  walls.infill = {};
  walls.motion.internal_bridge_flow = 0;
  for (int i = 0; i < kFeatureCount; ++i)
    if (!IsOfWalls(static_cast<Feature>(i))) walls.motion.speed_mm_s[static_cast<size_t>(i)] = 0;
  return walls;
}

}  // namespace

absl::StatusOr<int32_t> RegionTable::RowOf(const JobRows& settings) {
  RegionRow region = FdmOf(settings).region;
  const RegionRow walls = WallsOf(region);
  auto known = std::ranges::find(wall_classes_, walls);
  if (known == wall_classes_.end()) known = wall_classes_.insert(known, walls);
  region.walls.wall_class = static_cast<int32_t>(known - wall_classes_.begin());
  return table_.Add(region);
}

absl::StatusOr<int32_t> RegionTable::TurnedRow(int32_t row, double angle_rad) {
  const RegionRow& unturned = table_.rows()[static_cast<size_t>(row)];
  if (!unturned.infill.follows_model) return row;
  RegionRow region = unturned;
  region.infill.turn_rad = angle_rad;
  return table_.Add(region);
}

}  // namespace slicefarm::config::fdm
