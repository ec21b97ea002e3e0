#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/compatible.h"
#include "common/config/presets/preset_set.h"

namespace slicefarm::config::presets {

/// Names of presets as a user gives them. An empty process or filament is the printer's default, or
/// the preset with the default's alias that is made for the printer.
struct PresetNames {
  std::string printer;
  std::string process;
  std::string filament;
};

/// Presets of a job. They point into the PresetSet.
struct ChosenPresets {
  const Preset* printer = nullptr;
  const Preset* process = nullptr;
  const Preset* filament = nullptr;
};

/// Returns the printers of this name: the preset, or all presets of the model with this name.
/// Errors: PROFILE_NOT_FOUND with the most similar name (metadata `preset`, `suggestion`).
absl::StatusOr<std::vector<const Preset*>> PrintersNamed(const PresetSet& set,
                                                         std::string_view name);

/// Returns the listed presets of a kind that are made for the printer, by name.
std::vector<const Preset*> MadeFor(const PresetSet& set, const PrinterFit& fit, PresetKind kind);

/// Returns the presets of a job. A process or filament may be named by its alias ("0.20mm
/// Standard" for "0.20mm Standard @MK4") if only one preset with it is made for the printer.
///
/// Errors: PROFILE_NOT_FOUND for a name that no preset has (metadata `preset` and, if there is a
/// similar name, `suggestion`), and for a printer without a default; REQUEST_MALFORMED for a model
/// with several presets, and for a preset that is not made for the printer or process; as
/// PresetSet::Lineage.
absl::StatusOr<ChosenPresets> ChoosePresets(const PresetSet& set, const PresetNames& names);

}  // namespace slicefarm::config::presets
