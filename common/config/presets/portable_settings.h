#pragma once

#include <string>
#include <string_view>

#include "common/config/presets/preset.h"
#include "common/model/setting.h"

namespace slicefarm::config::presets {

/// Properties of two printers that decide whether settings for one of them fit the other.
struct PrinterChange {
  double from_nozzle_mm = 0;  ///< 0: unknown
  double to_nozzle_mm = 0;
  double min_layer_mm = 0;
  double max_layer_mm = 0;     ///< highest layer of the new printer; 0: no limit
  bool same_material = false;  ///< true if both filaments have the same type
};

/// Returns the reason why a designer's setting does not fit the new printer, or an empty text if it
/// fits. `kind`: kind of the presets that have the setting.
/// - Process: all settings fit, except settings for a firmware or host, widths in mm for another
/// nozzle,
///   and layer heights beyond the printer's limits.
/// - Filament: only cooling fits, and only for the same material. Temperatures, flow, retraction
/// and
///   code belong to the printer and its filament.
std::string WhyUnfit(PresetKind kind, const Setting& setting, const PrinterChange& change);

/// Returns true if a setting of a process describes the part and not how a printer moves: shells,
/// infill, supports, brim, seam, surface, but no speeds, accelerations, widths or flows.
bool DescribesPart(PresetDialect dialect, std::string_view key);

}  // namespace slicefarm::config::presets
