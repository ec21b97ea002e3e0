#include "common/model/layers/filament_use.h"

#include "common/model/options/motion_options.h"

namespace slicefarm {

double PrinterCost(const MotionOptions& options, double time_s) {
  constexpr double kSecondsPerHour = 3600;
  return options.cost_per_hour * time_s / kSecondsPerHour;
}

FilamentUse FilamentUseOf(const ProgramStats& total, const MotionOptions& options) {
  return FilamentUseOf(
      FeatureUse{.filament_mm = total.FilamentMm(), .volume_mm3 = total.VolumeMm3()}, options);
}

FilamentUse FilamentUseOf(const FeatureUse& total, const MotionOptions& options) {
  FilamentUse use;
  use.length_mm = total.filament_mm;
  use.volume_mm3 = total.volume_mm3;
  use.mass_g = use.volume_mm3 / 1000 * options.tool().filament_density_g_cm3;
  use.cost = use.mass_g / 1000 * options.tool().filament_cost_per_kg;
  return use;
}

}  // namespace slicefarm
