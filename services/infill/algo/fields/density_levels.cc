#include "services/infill/algo/fields/density_levels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "services/infill/algo/fields/field_cells.h"

namespace slicefarm::infill {
namespace {

/// Returns the threshold at a height. Over each period it rises from 0 to 1 and falls again.
double ThresholdAt(double z_mm) {
  const double swings = z_mm / kLevelSwingMm;
  const double share = swings - std::floor(swings);
  return share < 0.5 ? 2 * share : 2 - 2 * share;
}

double NextLevel(double level) {
  const double next = level * kLevelStep;
  return next < kLeastLevel ? 0 : next;
}

/// Returns the level of a point with this density; `high` is the greatest level. 0: the point stays
/// empty.
double LevelOf(double density, double high, double threshold) {
  double low = NextLevel(high);
  while (density < low) {
    high = low;
    low = NextLevel(high);
  }
  const double share = (density - low) / (high - low);
  return share >= 1 || share > threshold ? high : low;
}

}  // namespace

absl::StatusOr<std::vector<DensityPart>> LevelParts(const MultiPolygon& region,
                                                    const LayerField& field, double cell_mm) {
  std::vector<DensityPart> parts;
  const auto cells = FieldCellsOf(region, field, cell_mm);
  if (!cells.ok()) return cells.status();
  const double greatest = field.density->Greatest();
  const double threshold = ThresholdAt(field.z_mm);
  std::map<double, std::vector<char>> on_by_level;
  for (size_t i = 0; i < cells->density.size(); ++i) {
    const double level = LevelOf(cells->density[i], greatest, threshold);
    if (cells->touched[i] == 0 || level <= 0) continue;
    auto& on = on_by_level.try_emplace(level, cells->density.size(), char{0}).first->second;
    on[i] = 1;
  }
  for (auto& [level, on] : on_by_level)
    parts.push_back({PartInCells(region, *cells, std::move(on)), level});
  return parts;
}

}  // namespace slicefarm::infill
