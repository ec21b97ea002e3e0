#pragma once

#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/preset_set.h"
#include "common/macro/template_value.h"

namespace slicefarm::config::presets {

/// Decides if process and filament presets are made for a printer preset, by the rules of the
/// presets' program. The list `compatible_printers` has the names of printers. If the list is
/// empty, `compatible_printers_condition` decides. A condition that cannot be evaluated counts as
/// true.
///
/// OrcaSlicer has two more rules. For a user's printer, the list may also name the printer's
/// parent. A filament of OrcaSlicer's library is refused if another filament with the same alias
/// names the printer. PrusaSlicer accepts only presets of the printer's vendor, presets of users,
/// and templates (PresetScope::templates).
class PrinterFit {
 public:
  /// Prepares the test for a printer. Errors: any error of PresetSet::Lineage. `set` must outlive
  /// the result. Cost: O(presets).
  static absl::StatusOr<PrinterFit> Make(const PresetSet& set, const Preset& printer);

  /// Returns true if the process or filament preset is made for the printer. Returns false for a
  /// preset with a missing parent.
  bool Accepts(const Preset& preset) const;

 private:
  PrinterFit(const PresetSet& set, const Preset& printer) : set_(&set), printer_(&printer) {}

  bool HasAllowedVendor(const Preset& preset) const;
  bool IsNamedIn(const std::vector<std::string>& names) const;

  const PresetSet* set_;
  const Preset* printer_;
  /// vendor of the printer; for a user's printer, vendor of the nearest ancestor that has one
  std::string vendor_;
  macro::TemplateVariables variables_;  ///< the printer's settings
  /// aliases of filaments outside of OrcaSlicer's library that name the printer
  std::set<std::string> held_;
};

/// Returns true if the filament preset is made for the process preset. The filament's list
/// `compatible_prints` decides; if the list is empty, its `compatible_prints_condition`.
bool AcceptsProcess(const PresetSet& set, const Preset& filament, const Preset& process);

}  // namespace slicefarm::config::presets
