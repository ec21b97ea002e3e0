#include "common/config/presets/portable_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "common/base/text.h"
#include "common/config/presets/preset_keys.h"
#include "common/config/table/value.h"

namespace slicefarm::config::presets {
namespace {

/// Settings of a process for a firmware or a host, by the names of all programs.
constexpr std::string_view kOfFirmware[] = {
    "accel_to_decel_enable", "accel_to_decel_factor",  "arc_fitting",    "enable_arc_fitting",
    "exclude_object",        "filename_format",        "gcode_comments", "gcode_add_line_number",
    "gcode_label_objects",   "output_filename_format", "post_process",   "timelapse_type",
    "wipe_tower_x",          "wipe_tower_y",           "wipe_tower"};

constexpr std::string_view kLayerHeights[] = {"layer_height", "initial_layer_print_height",
                                              "first_layer_height"};

/// Settings of a filament that say how the part is cooled, by the names of all programs.
constexpr std::string_view kCooling[] = {"bridge_fan_speed",
                                         "close_fan_the_first_x_layers",
                                         "cooling",
                                         "disable_fan_first_layers",
                                         "dont_slow_down_outer_wall",
                                         "enable_dynamic_fan_speeds",
                                         "enable_overhang_bridge_fan",
                                         "fan_always_on",
                                         "fan_below_layer_time",
                                         "fan_cooling_layer_time",
                                         "fan_max_speed",
                                         "fan_min_speed",
                                         "full_fan_speed_layer",
                                         "internal_bridge_fan_speed",
                                         "ironing_fan_speed",
                                         "max_fan_speed",
                                         "min_fan_speed",
                                         "min_print_speed",
                                         "overhang_fan_speed",
                                         "overhang_fan_speed_0",
                                         "overhang_fan_speed_1",
                                         "overhang_fan_speed_2",
                                         "overhang_fan_speed_3",
                                         "overhang_fan_threshold",
                                         "reduce_fan_stop_start_freq",
                                         "slow_down_for_layer_cooling",
                                         "slow_down_layer_time",
                                         "slow_down_min_speed",
                                         "slowdown_below_layer_time",
                                         "support_material_interface_fan_speed"};

/// Parts of the names of settings that say how a printer moves.
constexpr std::string_view kOfMoves[] = {
    "accel",    "arc_",           "compensation", "extruder",      "filament",        "flow",
    "gcode",    "jerk",           "prime_",       "resolution",    "scarf",           "speed",
    "standby",  "travel",         "wipe",         "line_width",    "extrusion_width", "_notes",
    "filename", "print_sequence", "timelapse",    "exclude_object"};

bool ListHas(std::string_view key, std::span<const std::string_view> keys) {
  return std::ranges::find(keys, key) != keys.end();
}

/// Returns the number of a value or of the first item of a list, unless it is a percentage.
std::optional<double> LengthOf(std::string_view value) {
  const std::vector<std::string> items = ListItems(value);
  return items.empty() ? std::nullopt : ToNumber(items.front());
}

std::string WhyLayerHeightUnfit(std::string_view value, const PrinterChange& change) {
  const std::optional<double> height = LengthOf(value);
  if (!height || *height <= 0) return "";
  if (change.max_layer_mm > 0 && *height > change.max_layer_mm)
    return fmt::format(
        "layers of {} mm are higher than the printer's largest layer height of {} mm",
        PrintNumber(*height), PrintNumber(change.max_layer_mm));
  if (*height < change.min_layer_mm)
    return fmt::format(
        "layers of {} mm are lower than the printer's smallest layer height of {} mm",
        PrintNumber(*height), PrintNumber(change.min_layer_mm));
  return "";
}

/// Checks the heights of variable layers: pairs of z and height.
std::string WhyProfileUnfit(std::string_view value, const PrinterChange& change) {
  const std::vector<std::string_view> numbers = Split(value, ";,");
  for (size_t i = 1; i < numbers.size(); i += 2)
    if (std::string why = WhyLayerHeightUnfit(Trim(numbers[i]), change); !why.empty()) return why;
  return "";
}

}  // namespace

std::string WhyUnfit(PresetKind kind, const Setting& setting, const PrinterChange& change) {
  const std::string& key = setting.key;
  if (kind == PresetKind::kPrinter) return "belongs to the printer";
  if (kind == PresetKind::kFilament) {
    if (!ListHas(key, kCooling)) return "belongs to the printer's filament";
    return change.same_material ? "" : "is for another material";
  }
  if (ListHas(key, kOfFirmware)) return "belongs to the printer";
  if (ListHas(key, kLayerHeights)) return WhyLayerHeightUnfit(setting.value, change);
  if (key == "layer_height_profile") return WhyProfileUnfit(setting.value, change);
  const bool width = key.ends_with("line_width") || key.ends_with("extrusion_width");
  const bool same_nozzle =
      change.from_nozzle_mm > 0 && std::abs(change.from_nozzle_mm - change.to_nozzle_mm) < 1e-6;
  if (!width || same_nozzle || LengthOf(setting.value).value_or(0) == 0) return "";
  return fmt::format("is for a nozzle of {} mm", change.from_nozzle_mm);
}

bool DescribesPart(PresetDialect dialect, std::string_view key) {
  const bool of_process = MayHaveKey(PresetKind::kProcess, dialect, key) &&
                          !MayHaveKey(PresetKind::kPrinter, dialect, key) &&
                          !MayHaveKey(PresetKind::kFilament, dialect, key);
  return of_process && std::ranges::none_of(kOfMoves, [&](std::string_view part) {
           return key.find(part) != std::string_view::npos;
         });
}

}  // namespace slicefarm::config::presets
