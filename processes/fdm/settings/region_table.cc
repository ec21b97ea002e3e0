#include "processes/fdm/settings/region_table.h"

#include <fmt/core.h>

#include <algorithm>

#include "common/base/error.h"
#include "common/model/limits.h"

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

absl::Status TooManyAngles() {
  constexpr const char* kSetting = "align_infill_direction_to_model";
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{}: each rotation of a copy needs its own settings of regions, and "
                               "a plate has at most {} of them",
                               kSetting, limits::kMaxRegionSettings),
                   {{"setting", kSetting}});
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
  const absl::StatusOr<int32_t> turned = table_.Add(region);
  return turned.ok() ? turned : TooManyAngles();
}

}  // namespace slicefarm::config::fdm
