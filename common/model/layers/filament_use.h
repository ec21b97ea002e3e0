#pragma once

#include "common/model/layers/layer.h"
#include "common/model/options/settings.h"

namespace slicefarm {

struct MotionOptions;

/// Filament that a print uses.
struct FilamentUse {
  double length_mm = 0;
  double volume_mm3 = 0;
  double mass_g = 0;
  double cost = 0;  ///< cost in the currency of the settings

  friend bool operator==(const FilamentUse&, const FilamentUse&) = default;
};

/// Returns the cost of the printer for a time (time_cost).
double PrinterCost(const MotionOptions& options, double time_s);

/// Return the filament use of a print, or of a part of it, from its totals and the filament's
/// settings.
FilamentUse FilamentUseOf(const ProgramStats& total, const MotionOptions& options);
FilamentUse FilamentUseOf(const FeatureUse& total, const MotionOptions& options);

}  // namespace slicefarm
