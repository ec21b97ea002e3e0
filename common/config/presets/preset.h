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

/// Program that defines the names and values of a preset. Bambu Studio has OrcaSlicer's dialect.
enum class PresetDialect : uint8_t { kOrca, kPrusa, kSuper };

/// Group of presets that were read together and that find their parents among each other.
struct PresetScope {
  std::string vendor;      ///< name of the vendor; empty for presets of a user
  bool templates = false;  ///< PrusaSlicer: filaments that fit printers of all vendors
};

/// One preset as its file has it, without the settings of its parents.
struct Preset {
  PresetKind kind = PresetKind::kPrinter;
  PresetDialect dialect = PresetDialect::kOrca;
  std::string name;
  std::string alias;   ///< short name that presets for several printers share: "0.20mm Standard"
  int32_t scope = 0;   ///< index of the PresetScope
  std::string file;    ///< path of the file, for messages
  bool listed = true;  ///< false: only other presets inherit from it
  /// Names of the presets that this preset inherits from. A later parent overrides an earlier one.
  std::vector<std::string> parents;
  /// True if the file has all settings, so that a parent that is not there does not matter.
  bool complete = false;
  bool whole_job = false;  ///< true if the preset has all settings of a job
  std::vector<std::string> old_names;
  std::vector<Setting> settings;  ///< own settings; of equal keys the last one counts
};

/// Model of a printer as vendors list them. Printer presets name it as `printer_model`.
struct PrinterModel {
  std::string id;
  int32_t scope = 0;
  std::string name;                    ///< name that users see: "Original Prusa MK4S"
  std::string bed_type;                ///< OrcaSlicer's `default_bed_type`; may be empty
  std::vector<std::string> materials;  ///< filaments for a printer that names no default
};

/// Returns the items of a list as presets write it: JSON (`["a","b"]`) or `a;"b; c"`. Empty items
/// are left out.
std::vector<std::string> ListItems(std::string_view text);

/// Returns the part of a preset's name before the first `@`; the whole name if there is none.
std::string AliasOf(std::string_view name);

}  // namespace slicefarm::config::presets
