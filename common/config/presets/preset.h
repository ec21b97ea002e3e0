#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "common/model/setting.h"

namespace slicefarm::config::presets {

enum class PresetKind : uint8_t { kPrinter, kProcess, kFilament };

/// Returns "printer", "process" or "filament".
std::string_view KindName(PresetKind kind);

/// Program that defines the names and values of a preset's settings. Presets of Bambu Studio are
/// kOrca.
enum class PresetDialect : uint8_t { kOrca, kPrusa, kSuper };

/// Group of presets that were read together, such as a vendor's folder. A parent is first looked up
/// in the group of its child.
struct PresetScope {
  std::string vendor;      ///< name of the vendor; empty for presets of a user
  bool templates = false;  ///< true for PrusaSlicer's filaments that fit printers of all vendors
};

/// A preset as its file contains it, without the settings of its parents.
struct Preset {
  PresetKind kind = PresetKind::kPrinter;
  PresetDialect dialect = PresetDialect::kOrca;
  std::string name;
  std::string alias;  ///< short name that presets for several printers share: "0.20mm Standard"
  int32_t scope = 0;  ///< index of the preset's PresetScope in the PresetSet
  std::string file;   ///< path of the file, for messages
  /// true: users can choose the preset; false: only other presets inherit from it
  bool listed = true;
  /// Names of the presets that this preset inherits from. A later parent overrides an earlier one.
  std::vector<std::string> parents;
  /// True if the file has all settings. Then a missing parent is no error.
  bool complete = false;
  bool whole_job = false;  ///< true if the preset has all settings of a job
  std::vector<std::string> old_names;
  /// settings of the preset's own file; if a key is repeated, its last value counts
  std::vector<Setting> settings;
};

/// Model of a printer in a vendor's list. Printer presets refer to the `id` of their model by the
/// setting `printer_model`.
struct PrinterModel {
  std::string id;
  int32_t scope = 0;
  std::string name;      ///< name that users see: "Original Prusa MK4S"
  std::string bed_type;  ///< OrcaSlicer's `default_bed_type`; may be empty
  /// default filaments, used if no default of the printer preset is found
  std::vector<std::string> materials;
};

/// Returns the items of a list as presets write it: JSON (`["a","b"]`) or `a;"b; c"`. Empty items
/// are left out.
std::vector<std::string> ListItems(std::string_view text);

/// Returns the first number of a list: JSON, or numbers separated by `,` or `;`; 0 if there is
/// none.
double FirstNumber(std::string_view list);

/// Returns the part of a preset's name before the first `@`; the whole name if there is none.
std::string AliasOf(std::string_view name);

}  // namespace slicefarm::config::presets
