#include "common/config/table/known_keys.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "common/base/text.h"

namespace slicefarm::config {
namespace {

constexpr std::string_view kNotYet = "not supported yet";
constexpr std::string_view kSeveral =
    "not supported yet, and not needed for prints with one extruder";
constexpr std::string_view kProfile = "describes the profile, not the print";
constexpr std::string_view kSending = "concerns sending files to a printer";
constexpr std::string_view kResin = "concerns resin printers";

/// Settings that switch a feature on or off, with the value that requests the usual behaviour.
constexpr KnownKey kSwitches[] = {
    // These settings change the part, or decide if it prints at all.
    {"post_process", "scripts are never run", "", true, true, true},
    {.key = "printer_technology",
     .why = kResin,
     .neutral = "FFF",
     .has_neutral = true,
     .changes_print = true,
     .spoils_print = true},
    // These settings improve the part or change details of it.
    {.key = "colorprint_heights",
     .why = kNotYet,
     .has_neutral = true,
     .changes_print = true,
     .spoils_print = true},
    {"extrusion_axis", kNotYet, "E", true},
    {"infill_extruder", kNotYet, "0|1", true},
    {"interlocking_beam", kNotYet, "0", true},
    {"ooze_prevention", "acts only where tools change", "0", true},
    {"perimeter_extruder", kNotYet, "0|1", true},
    {"solid_infill_extruder", kNotYet, "0|1", true},
    {"support_material_extruder", kNotYet, "0|1", true},
    {"support_material_interface_extruder", kNotYet, "0|1", true},
    {"wipe_into_infill", kNotYet, "0", true},
    {"wipe_into_objects", kNotYet, "0", true},
};

struct Group {
  std::string_view why;
  std::string_view keys;  // by spaces; `*` at the end: all that begin so
  bool reported = true;
};

/// Settings of features that do not exist yet, and settings that slicing never reads.
constexpr Group kGroups[] = {
    {kNotYet, "clip_multipart_objects interlocking_*"},
    {kSeveral,
     "bed_temperature_extruder "
     "cooling_tube_* "
     "extra_loading_move "
     "filament_cooling_* filament_load_time filament_loading_* "
     "filament_minimal_purge_on_wipe_tower filament_multitool_* filament_purge_multiplier "
     "filament_ramming_parameters filament_retract_length_toolchange "
     "filament_retract_restart_extra_toolchange "
     "filament_soluble filament_stamping_* filament_toolchange_delay "
     "filament_unload_time filament_unloading_* "
     "high_current_on_filament_swap "
     "mmu_* multimaterial_purging "
     "parking_pos_retraction retract_length_toolchange "
     "retract_restart_extra_toolchange "
     "single_extruder_multi_material single_extruder_multi_material_priming "
     "standby_temperature_delta toolchange_gcode "
     "wipe_tower wipe_tower_* wiping_volumes_*"},
    {kProfile,
     "bed_custom_model bed_custom_texture color_change_* custom_parameters_* "
     "default_filament_profile "
     "default_print_profile default_sla_* extruder_colour filament_notes filament_spool_weight "
     "filament_abrasive filament_vendor inherits inherits_* notes "
     "nozzle_high_flow physical_printer_settings_id preset_name preset_names print_settings_id "
     "printer_notes "
     "printer_settings_id printer_variant printer_vendor profile_vendor profile_version "
     "variable_layer_height"},
    {"chooses between several tools, but a job prints with one tool", "idle_temperature"},
    {"its results are already in the width settings", "automatic_extrusion_widths"},
    {kProfile, "compatible_*", false},
    {kSending, "host_type print_host printhost_* octoprint_* serial_*", false},
    {kResin, "sla_* faded_layers exposure_* pad_* hollowing_* area_fill display_* tilt_*", false},
    {"replaced by the option --threads", "threads", false},
};

std::vector<KnownKey> MakeKnownKeys() {
  std::vector<KnownKey> table(std::begin(kSwitches), std::end(kSwitches));
  for (const Group& group : kGroups) {
    for (const std::string_view key : Split(group.keys, " ")) {
      const bool of_print = group.why == kNotYet || group.why == kSeveral;
      table.push_back({.key = key,
                       .why = group.why,
                       .of_print = of_print,
                       .reported = group.reported,
                       .of_several_extruders = group.why == kSeveral});
    }
  }
  return table;
}

bool Matches(std::string_view pattern, std::string_view key) {
  if (!pattern.ends_with("*")) return pattern == key;
  return key.starts_with(pattern.substr(0, pattern.size() - 1));
}

/// Removes the percent sign, so that 0 equals 0%.
std::string_view WithoutPercent(std::string_view text) {
  return text.ends_with('%') ? text.substr(0, text.size() - 1) : text;
}

bool SameValue(std::string_view a, std::string_view b) {
  if (ToNumber(WithoutPercent(a)) == 0 && ToNumber(WithoutPercent(b)) == 0) return true;
  const auto x = ToNumber(a);
  const auto y = ToNumber(b);
  return x.has_value() && y.has_value() ? *x == *y : a == b;
}

}  // namespace

const KnownKey* FindKnownKey(std::string_view key) {
  static const std::vector<KnownKey>& table = *new std::vector<KnownKey>(MakeKnownKeys());
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const KnownKey& k) { return Matches(k.key, key); });
  return found == table.end() ? nullptr : &*found;
}

bool IsNeutral(const KnownKey& key, std::string_view value) {
  if (!key.has_neutral) return false;
  if (value == "\"\"") value = "";  // an empty text in a list
  const std::vector<std::string_view> neutral = Split(key.neutral, "|");
  return std::ranges::all_of(Split(value, ",;"), [&](std::string_view item) {
    return std::ranges::any_of(neutral,
                               [&](std::string_view each) { return SameValue(Trim(item), each); });
  });
}

}  // namespace slicefarm::config
