#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/compatible.h"
#include "common/config/presets/preset_set.h"

namespace slicefarm::config::presets {

/// Names of presets as a user gives them. If the process or filament is empty, the printer's
/// default is used: the preset of this name, or the preset with the same alias that is made for the
/// printer.
struct PresetNames {
  std::string printer;
  std::string process;
  std::string filament;
};

/// Presets of a job: pointers to elements of the PresetSet.
struct ChosenPresets {
  const Preset* printer = nullptr;
  const Preset* process = nullptr;
  const Preset* filament = nullptr;
};

/// Returns the printer presets with this name. If there are none, returns all presets of the
/// printer model with this name. Errors: PROFILE_NOT_FOUND with the most similar name (metadata
/// `preset`, `suggestion`).
absl::StatusOr<std::vector<const Preset*>> PrintersNamed(const PresetSet& set,
                                                         std::string_view name);

/// Returns the listed presets of a kind that are made for the printer, sorted by name.
std::vector<const Preset*> MadeFor(const PresetSet& set, const PrinterFit& fit, PresetKind kind);

/// Returns the presets of a job. A process or filament may also be named by its alias, if only one
/// preset with this alias is made for the printer. Example: "0.20mm Standard" for "0.20mm Standard
/// @MK4".
///
/// Errors:
/// - PROFILE_NOT_FOUND for a name that no preset has (metadata `preset` and, if there is a similar
///   name, `suggestion`), and for an empty name if the printer has no default;
/// - REQUEST_MALFORMED for the name of a printer model with several presets, and for an alias of
///   several presets;
/// - REQUEST_MALFORMED for a preset that is not made for the printer or process;
/// - any error of PresetSet::Lineage.
absl::StatusOr<ChosenPresets> ChoosePresets(const PresetSet& set, const PresetNames& names);

}  // namespace slicefarm::config::presets
