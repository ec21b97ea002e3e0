#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/compatible.h"
#include "common/config/presets/preset_set.h"

namespace slicefarm::config::presets {

/// Names of presets as a user gives them. If the name of the process or filament preset is empty,
/// the printer's default is used: the preset of this name, or the preset with the same alias that
/// is made for the printer.
struct PresetNames {
  std::string printer;
  std::string process;
  std::string filament;
};

/// Presets that the job was made with for another printer. The corresponding presets of the printer
/// are chosen if no names are given. Empty: none.
struct FormerPresets {
  std::string process_alias;   ///< "0.20mm Standard"
  std::string layer_height;    ///< in mm
  std::string filament_alias;  ///< "Generic PLA"
  std::string filament_type;   ///< "PLA"
};

/// Presets of a job. They point into the PresetSet.
struct ChosenPresets {
  const Preset* printer = nullptr;
  const Preset* process = nullptr;
  const Preset* filament = nullptr;
  std::vector<std::string> notes = {};  ///< choices that a user may not expect, as lines
};

/// Returns the printer presets with this name. If there are none, returns all presets of the
/// printer model with this name. Errors: PROFILE_NOT_FOUND with the most similar name (metadata
/// `preset`, `suggestion`).
absl::StatusOr<std::vector<const Preset*>> PrintersNamed(const PresetSet& set,
                                                         std::string_view name);

/// Returns the listed presets of a kind that are made for the printer, sorted by name.
std::vector<const Preset*> MadeFor(const PresetSet& set, const PrinterFit& fit, PresetKind kind);

/// Returns all presets that a job may name, or the printers of a name with the presets that are
/// made for them; by kind and name. `printer` may be empty. Errors: as PrintersNamed and
/// PresetSet::Lineage.
absl::StatusOr<std::vector<const Preset*>> ListedPresets(const PresetSet& set,
                                                         std::string_view printer);

/// Returns the presets of a job. A process or filament may be named by its alias ("0.20mm
/// Standard" for "0.20mm Standard @MK4") if only one preset with it is made for the printer.
///
/// Without a name, the preset is chosen as the programs do it when the printer changes: one with
/// the alias of the former preset, else one with its layer height or type, else the printer's
/// default. If there is no such preset, the first one by name that fits is used, for filaments the
/// first PLA, with a note.
///
/// Errors: PROFILE_NOT_FOUND for a name that no preset has (metadata `preset` and, if there is a
/// similar name, `suggestion`), and if no preset fits; REQUEST_MALFORMED for a model with several
/// presets, and for a preset that is not made for the printer or process; as PresetSet::Lineage.
absl::StatusOr<ChosenPresets> ChoosePresets(const PresetSet& set, const PresetNames& names,
                                            const FormerPresets& former = {});

}  // namespace slicefarm::config::presets
