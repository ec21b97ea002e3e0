#pragma once

#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/presets/preset_set.h"
#include "common/macro/template_value.h"

namespace slicefarm::config::presets {

/// Printer preset that processes and filaments are matched with, as in the presets' program. The
/// list `compatible_printers` has names. If it is empty, `compatible_printers_condition` decides. A
/// condition that cannot be evaluated excludes nothing.
///
/// OrcaSlicer also accepts a list that has the parent of a user's printer. It hides a filament of
/// its library if a vendor has a filament with the same alias for the printer. PrusaSlicer only
/// accepts presets of the printer's vendor and of users.
class PrinterFit {
 public:
  /// Errors: as PresetSet::Lineage. `set` must outlive the result. Cost: O(presets).
  static absl::StatusOr<PrinterFit> Make(const PresetSet& set, const Preset& printer);

  /// Returns true if the process or filament is made for the printer. Returns false for a preset
  /// with a missing parent.
  bool Accepts(const Preset& preset) const;

 private:
  PrinterFit(const PresetSet& set, const Preset& printer) : set_(&set), printer_(&printer) {}

  bool HasAllowedVendor(const Preset& preset) const;
  bool IsNamedIn(const std::vector<std::string>& names) const;

  const PresetSet* set_;
  const Preset* printer_;
  std::string vendor_;                  ///< vendor of the printer, or of the one it inherits from
  macro::TemplateVariables variables_;  ///< the printer's settings
  std::set<std::string> held_;          ///< aliases of vendors' filaments that name the printer
};

/// Returns true if the filament is made for the process: `compatible_prints`, or else
/// `compatible_prints_condition`.
bool AcceptsProcess(const PresetSet& set, const Preset& filament, const Preset& process);

}  // namespace slicefarm::config::presets
