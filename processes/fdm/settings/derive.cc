#include "processes/fdm/settings/derive.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "common/base/text.h"
#include "common/config/derive_steps.h"
#include "common/config/table/settings_table.h"
#include "common/model/options/fill_patterns.h"
#include "common/model/options/motion_options.h"
#include "processes/fdm/settings/joined_gcode.h"

namespace slicefarm::config::fdm {
namespace {

constexpr double kWidthPerNozzle = 1.125;  // default width of a bead, in nozzle diameters

constexpr std::string_view kSpeeds[] = {
    "perimeter_speed",        "external_perimeter_speed",
    "small_perimeter_speed",  "infill_speed",
    "solid_infill_speed",     "top_solid_infill_speed",
    "gap_fill_speed",         "bridge_speed",
    "support_material_speed", "support_material_interface_speed",
    "ironing_speed",
};

/// Sparse infill patterns with lines that cross each other in one layer.
constexpr FillPattern kCrossing[] = {FillPattern::kGrid,          FillPattern::kTriangles,
                                     FillPattern::kStars,         FillPattern::kCubic,
                                     FillPattern::kAdaptiveCubic, FillPattern::kSupportCubic,
                                     FillPattern::kQuarterCubic};

void DeriveWidth(SettingValues& draft, std::string_view key, double auto_width) {
  Value width = *draft.At(key).value;
  if (width.number == 0) width = *draft.At("extrusion_width").value;
  const double mm = Absolute(width, draft.Number("layer_height"));
  draft.SetNumber(key, mm == 0 ? auto_width : mm);
}

void DeriveWidths(SettingValues& draft) {
  const double nozzle = draft.Number("nozzle_diameter");
  for (const std::string_view key :
       {"perimeter_extrusion_width", "external_perimeter_extrusion_width", "infill_extrusion_width",
        "solid_infill_extrusion_width"}) {
    DeriveWidth(draft, key, kWidthPerNozzle * nozzle);
  }
  DeriveWidth(draft, "top_infill_extrusion_width", nozzle);
  for (const std::string_view key : {"skin_infill_line_width", "skeleton_infill_line_width"}) {
    ResolvePercentage(draft, key);
    FallBack(draft, key, "infill_extrusion_width");
  }
  DeriveWidth(draft, "support_material_extrusion_width", nozzle);
  ResolvePercentage(draft, "support_material_xy_spacing");
  FallBack(draft, "support_material_bottom_contact_distance", "support_material_contact_distance");
  if (draft.Number("support_material_bottom_interface_layers") < 0)
    draft.SetNumber("support_material_bottom_interface_layers",
                    draft.Number("support_material_interface_layers"));
  ResolvePercentage(draft, "first_layer_extrusion_width");
  ResolvePercentage(draft, "bridge_line_width");
  FallBack(draft, "first_layer_extrusion_width", "perimeter_extrusion_width");
  ResolvePercentage(draft, "extrusion_width");
}

void DeriveVariableWalls(SettingValues& draft) {
  for (const std::string_view key :
       {"wall_transition_length", "wall_transition_filter_deviation", "min_feature_size",
        "min_bead_width", "max_bead_width", "first_layer_min_bead_width"}) {
    ResolvePercentage(draft, key);
  }
}

/// Limits the infill speed to the filament's limit, which may be lower for patterns with crossing
/// lines.
void LimitInfillSpeed(SettingValues& draft) {
  const auto pattern = static_cast<FillPattern>(std::lround(draft.Number("fill_pattern")));
  const bool crosses = std::ranges::find(kCrossing, pattern) != std::end(kCrossing);
  const double limit =
      draft.Number(crosses ? "filament_infill_max_crossing_speed" : "filament_infill_max_speed");
  if (limit > 0) draft.SetNumber("infill_speed", std::min(draft.Number("infill_speed"), limit));
}

void DeriveSpeeds(SettingValues& draft) {
  for (const std::string_view key :
       {"external_perimeter_speed", "small_perimeter_speed", "solid_infill_speed",
        "top_solid_infill_speed", "over_bridge_speed", "internal_bridge_speed",
        "support_material_interface_speed", "first_layer_infill_speed", "overhang_speed_0",
        "overhang_speed_1", "overhang_speed_2", "overhang_speed_3"}) {
    ResolvePercentage(draft, key);
  }
  for (const std::string_view key : kSpeeds) {
    FallBack(draft, key, "max_print_speed");
  }
  LimitInfillSpeed(draft);
}

void DeriveAccelerations(SettingValues& draft) {
  FallBack(draft, "external_perimeter_acceleration", "perimeter_acceleration");
  FallBack(draft, "solid_infill_acceleration", "infill_acceleration");
  FallBack(draft, "top_solid_infill_acceleration", "solid_infill_acceleration");
}

/// Resets machine limits to their default values if the job ignores them.
void DeriveLimits(SettingValues& draft) {
  if (draft.Number("machine_limits_usage") != kIgnoreLimits) return;
  const auto table = SettingsTable(draft.process());
  for (const SettingSpec& spec : table) {
    if (!spec.key.starts_with("machine_max_") && !spec.key.starts_with("machine_min_")) continue;
    draft.SetNumber(spec.key, *ToNumber(spec.standard));
  }
}

/// Sets infill_every_layers to the number of layers that fit into the maximum height of combined
/// infill and into the nozzle diameter, within the range of the setting.
void DeriveCombination(SettingValues& draft) {
  constexpr std::string_view kHeight = "automatic_infill_combination_max_layer_height";
  ResolvePercentage(draft, kHeight);
  if (draft.Number("automatic_infill_combination") == 0) return;
  constexpr std::string_view kLayers = "infill_every_layers";
  const double height_mm = std::min(draft.Number(kHeight), draft.Number("nozzle_diameter"));
  constexpr double kRounding = 1e-6;
  const double layers = std::floor(height_mm / draft.Number("layer_height") + kRounding);
  const SettingSpec& spec = SettingsTable(draft.process())[FindSetting(kLayers, draft.process())];
  draft.SetNumber(kLayers, std::clamp(layers, spec.min, spec.max));
}

void DeriveFilament(SettingValues& draft) {
  constexpr std::string_view kPrefix = "filament_";
  const auto table = SettingsTable(draft.process());
  for (size_t i = 0; i < table.size(); ++i) {
    const SettingValues::Entry& own = draft.entries()[i];
    if (table[i].standard == kNotSet && own.value.has_value())
      draft.At(table[i].key.substr(kPrefix.size())).value = own.value;
  }
  FallBack(draft, "deretract_speed", "retract_speed");
  // With firmware retraction, only the machine has the retraction length. This assumed length is
  // used for times.
  if (draft.Number("use_firmware_retraction") != 0 && draft.Number("retract_length") == 0)
    draft.SetNumber("retract_length", 1);

  const double print_limit = draft.Number("max_volumetric_speed");
  const double filament_limit = draft.Number("filament_max_volumetric_speed");
  if (print_limit > 0 && (filament_limit == 0 || print_limit < filament_limit)) {
    draft.SetNumber("filament_max_volumetric_speed", print_limit);
  }
}

/// Returns true if G-code contains more than comments and commands that set E to 0. Many profiles
/// set E to 0 in each layer.
bool Acts(std::string_view gcode) {
  for (const std::string_view line : Split(gcode, "\n")) {
    const std::string_view code = Trim(line.substr(0, line.find(';')));
    if (!code.empty() && code != "G92 E0" && code != "G92 E0.0") return true;
  }
  return false;
}

/// Enables retraction at layer changes unless nothing is inserted between layers. Inserted G-code
/// may move the nozzle. If labelled objects are cancelled during the print, the printer must
/// continue in the same state.
void DeriveLayerChange(SettingValues& draft) {
  const auto text = [&](std::string_view key) -> std::string_view {
    return draft.At(key).value->text;
  };
  if (Acts(text("before_layer_gcode")) || Acts(text("layer_gcode")) ||
      !text("custom_gcode_per_print_z").empty() ||
      draft.Number("gcode_label_objects") != static_cast<int>(ObjectLabels::kNone))
    draft.SetNumber("retract_layer_change", 1);
}

/// Disables extra walls if there is no infill, because extra walls only replace infill.
void DeriveExtraWalls(SettingValues& draft) {
  const bool filled = draft.Number("fill_density") > 0 && draft.Number("perimeters") > 0;
  if (!filled) draft.SetNumber("extra_perimeters", 0);
}

/// Adds the format of thumbnails_format to thumbnails that do not name a format.
void DeriveThumbnails(SettingValues& draft) {
  constexpr std::string_view kFormat = "thumbnails_format";
  const SettingSpec& spec = SettingsTable(draft.process())[FindSetting(kFormat, draft.process())];
  const std::string format = PrintValue(spec, *draft.At(kFormat).value);
  if (format == "PNG") return;
  SettingValues::Entry& thumbnails = draft.At("thumbnails");
  const std::string& written = thumbnails.given ? thumbnails.written : thumbnails.value->text.str();
  std::string text;
  for (const std::string_view size : Split(written, ",")) {
    const bool names_one = size.empty() || size.find('/') != size.npos;
    text += fmt::format("{}{}{}", text.empty() ? "" : ",", size, names_one ? "" : "/" + format);
  }
  if (const auto sizes = ParseSizes(text); sizes.ok()) thumbnails.value->text = PrintSizes(*sizes);
}

/// Limits the skirt to one layer if copies are printed one after another, because the head would
/// hit a taller one. This applies to values from profiles. A value that the request sets is checked
/// instead (check_settings.h). Returns a note if the height changed.
std::optional<std::string> DeriveSequentialSkirt(SettingValues& draft) {
  if (draft.Number("complete_objects") == 0 || draft.Number("skirts") == 0) return std::nullopt;
  const SettingValues::Entry& height = draft.At("skirt_height");
  if (height.requested || draft.Number("skirt_height") <= 1) return std::nullopt;
  std::string note = fmt::format(
      "skirt_height = {}: with complete_objects = 1 the skirt has only one layer, or the print "
      "head would hit the skirt",
      height.written);
  draft.SetNumber("skirt_height", 1);
  return note;
}

/// Sets one wall, no infill, no top layers and no Z contouring for a vase, even if profiles set
/// other values. Returns notes about changed values.
std::vector<std::string> DeriveVase(SettingValues& draft) {
  std::vector<std::string> notes;
  if (draft.Number("spiral_vase") == 0) return notes;
  constexpr std::pair<std::string_view, double> kVase[] = {
      {"perimeters", 1}, {"top_solid_layers", 0}, {"fill_density", 0}, {"zaa_enabled", 0}};
  for (const auto& [key, value] : kVase) {
    const SettingValues::Entry& entry = draft.At(key);
    if (draft.Number(key) == value) continue;
    if (entry.given)
      notes.push_back(fmt::format("{} = {}: with spiral_vase = 1 the value {} is used", key,
                                  entry.written, value));
    draft.SetNumber(key, value);
  }
  return notes;
}

/// Empties settings of a feature that is off: the area that nothing may enter, and the fit of the
/// filament's flow.
void DeriveFeaturesOff(SettingValues& draft) {
  const auto clear = [&](std::string_view key) { draft.At(key).value->text = std::string(); };
  if (draft.Number("enable_wrapping_detection") == 0) clear("wrapping_exclude_area");
  if (draft.At("wrapping_exclude_area").value->text.empty()) clear("wrapping_detection_gcode");
  if (draft.Number("filament_adaptive_volumetric_speed") == 0)
    clear("volumetric_speed_coefficients");
}

}  // namespace

absl::Status Derive(SettingValues& draft, ResolvedSettings& result) {
  if (auto note = DeriveSequentialSkirt(draft)) {
    result.no_effect.push_back({*note});
    result.warnings.push_back(*std::move(note));
  }
  for (std::string& note : DeriveVase(draft)) result.no_effect.push_back({std::move(note)});
  ResolvePercentage(draft, "first_layer_height");
  RaiseTo(draft, "outline_resolution", "resolution");
  DeriveWidths(draft);
  DeriveVariableWalls(draft);
  for (const std::string_view key :
       {"infill_overlap", "infill_anchor", "infill_anchor_max", "top_bottom_infill_overlap",
        "min_width_top_surface", "overhang_reverse_threshold"})
    ResolvePercentage(draft, key);
  // OrcaSlicer: without bridging walls there is no threshold.
  if (draft.Number("overhangs") == 0) draft.SetNumber("overhang_reverse_threshold", 0);
  DeriveSpeeds(draft);
  DeriveAccelerations(draft);
  DeriveLimits(draft);
  DeriveCombination(draft);
  DeriveFilament(draft);
  ResolvePercentage(draft, "seam_gap_distance");
  DeriveExtraWalls(draft);
  DeriveFeaturesOff(draft);
  absl::Status status = JoinGcode(draft);
  DeriveLayerChange(draft);
  DeriveThumbnails(draft);
  status.Update(CheckPercentages(draft));
  return status;
}

}  // namespace slicefarm::config::fdm
