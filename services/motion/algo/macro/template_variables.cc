#include "services/motion/algo/macro/template_variables.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "absl/strings/numbers.h"
#include "common/geometry/measure.h"
#include "common/base/duration_text.h"
#include "common/model/filament_use.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/gcode/comment_text.h"
#include "services/motion/algo/macro/settings_text.h"
#include "services/motion/algo/macro/template_defaults.h"

namespace slicefarm::motion {
namespace {

/// Corners of a bed beyond this are none.
constexpr double kFarthestMm = 10'000;

void AddExtruder(TemplateVariables& variables) {
  for (const char* name :
       {"initial_extruder", "initial_tool", "current_extruder", "next_extruder",
        "previous_extruder", "filament_extruder_id", "toolchange_count", "total_toolchanges"}) {
    variables[name] = {int64_t{0}};
  }
  for (const char* name : {"extruder_count", "num_extruders", "num_printing_extruders"}) {
    variables[name] = {int64_t{1}};
  }
  variables["is_extruder_used"] = {true};
  variables["has_wipe_tower"] = {false};
  variables["has_single_extruder_multi_material_priming"] = {false};
}

/// What the stage itself works with.
TemplateVariables OptionVariables(const MotionOptions& options) {
  TemplateVariables variables;
  const auto whole = [&](const char* name, int64_t value) { variables[name] = {value}; };
  const auto real = [&](const char* name, double value) { variables[name] = {value}; };
  const auto text = [&](const char* name, const std::string& value) { variables[name] = {value}; };
  whole("temperature", options.temperature_c);
  whole("first_layer_temperature", options.first_layer_temperature_c);
  whole("bed_temperature", options.bed_temperature_c);
  whole("first_layer_bed_temperature", options.first_layer_bed_temperature_c);
  real("nozzle_diameter", options.nozzle_diameter_mm);
  real("filament_diameter", options.filament_diameter_mm);
  real("filament_density", options.filament_density_g_cm3);
  real("filament_cost", options.filament_cost_per_kg);
  real("extrusion_multiplier", options.extrusion_multiplier);
  text("filament_type", options.filament_type);
  text("filament_colour", options.filament_colour);
  text("initial_filament_type", options.filament_type);
  text("printing_filament_types", options.filament_type);
  text("filament_settings_id", options.filament_settings_id);
  text("filament_preset", options.filament_settings_id);
  text("printer_model", options.printer_model);
  text("gcode_flavor", std::string(FirmwareOf(options.flavor).name()));
  real("z_offset", options.z_offset_mm);
  real("travel_speed", options.travel_speed_mm_s);
  real("retract_length", options.retraction.length_mm);
  real("retract_lift", options.retraction.lift_mm);
  real("retract_speed", options.retraction.speed_mm_s);
  whole("min_fan_speed", options.cooling.min_fan_percent);
  whole("max_fan_speed", options.cooling.max_fan_percent);
  whole("bridge_fan_speed", options.cooling.bridge_fan_percent);
  AddExtruder(variables);
  return variables;
}

std::vector<TemplateValue> ValuesOf(std::string_view key, std::string_view value) {
  std::vector<TemplateValue> values;
  for (const std::string& item : SettingItems(key, value)) {
    for (TemplateValue& part : ParseSetting(item)) values.push_back(std::move(part));
  }
  return values;
}

/// Those of `text` that have no value yet.
void AddSettings(std::string_view text, TemplateVariables& variables) {
  for (const auto& [key, value] : SettingLines(text)) {
    if (!variables.contains(key)) variables.emplace(key, ValuesOf(key, value));
  }
}

std::vector<TemplateValue> Pair(double x_nm, double y_nm) { return {ToMm(x_nm), ToMm(y_nm)}; }

/// name_min, name_max and name_size, in mm.
void AddBox(const std::string& name, const Box& box, TemplateVariables& variables) {
  const Point min = box.Empty() ? Point{} : box.min;
  const Point max = box.Empty() ? Point{} : box.max;
  const auto x = [](Point p) { return static_cast<double>(p.x); };
  const auto y = [](Point p) { return static_cast<double>(p.y); };
  variables[name + "_min"] = Pair(x(min), y(min));
  variables[name + "_max"] = Pair(x(max), y(max));
  variables[name + "_size"] = Pair(x(max) - x(min), y(max) - y(min));
}

/// The bounds of "0x0,250x0,250x210".
Box BedBox(std::string_view bed_shape) {
  Box box;
  while (!bed_shape.empty()) {
    const size_t end = std::min(bed_shape.find(','), bed_shape.size());
    const std::string_view corner = bed_shape.substr(0, end);
    bed_shape.remove_prefix(std::min(end + 1, bed_shape.size()));
    const size_t cross = std::min(corner.find('x'), corner.size());
    double x = 0;
    double y = 0;
    const bool read =
        absl::SimpleAtod(std::string(corner.substr(0, cross)), &x) &&
        absl::SimpleAtod(std::string(corner.substr(std::min(cross + 1, corner.size()))), &y);
    if (!read || !(std::abs(x) < kFarthestMm) || !(std::abs(y) < kFarthestMm)) continue;
    box.Add(Point{FromMm(x), FromMm(y)});
  }
  return box;
}

void AddPresets(TemplateVariables& variables) {
  variables["print_preset"] = variables["print_settings_id"];
  variables["printer_preset"] = variables["printer_settings_id"];
  variables["physical_printer_preset"] = variables["physical_printer_settings_id"];
}

/// The settings by name: as the stage has them, as they were given, as PrusaSlicer has them.
TemplateVariables SettingVariables(const MotionOptions& options, std::string_view given) {
  TemplateVariables variables = OptionVariables(options);
  AddSettings(given, variables);
  AddSettings(TemplateDefaults(), variables);
  AddPresets(variables);
  for (const auto& [key, value] : SettingLines(given)) {
    if (key == "bed_shape") AddBox("print_bed", BedBox(value), variables);
  }
  return variables;
}

void AddLayer(const LayerPlace& place, TemplateVariables& variables) {
  variables["current_object_idx"] = {int64_t{place.pass}};
  variables["layer_num"] = {int64_t{place.number}};
  variables["layer_z"] = {ToMm(static_cast<double>(place.print_z_nm))};
  variables["max_layer_z"] = {ToMm(static_cast<double>(place.top_nm))};
}

/// Where a program ends.
LayerPlace LastPlace(const ProgramSummary& summary) {
  LayerPlace last;
  if (summary.layers.empty()) return last;
  last.number = static_cast<int32_t>(summary.layers.size()) - 1;
  last.print_z_nm = summary.layers.back().frame.print_z_nm;
  last.top_nm = TopOf(summary);
  return last;
}

void AddUse(const MotionOptions& options, const ProgramStats& total, TemplateVariables& variables) {
  const FilamentUse use = FilamentUseOf(total, options);
  variables["used_filament"] = {use.length_mm / 1000};
  variables["extruded_volume"] = variables["extruded_volume_total"] = {use.volume_mm3};
  for (const char* name : {"total_weight", "extruded_weight", "extruded_weight_total"}) {
    variables[name] = {use.mass_g};
  }
  variables["total_cost"] = {use.cost};
  variables["total_wipe_tower_cost"] = variables["total_wipe_tower_filament"] = {0.0};
}

void AddTime(double time_s, TemplateVariables& variables) {
  for (const char* name : {"print_time", "normal_print_time", "silent_print_time"}) {
    variables[name] = {DurationText(time_s)};
  }
}

void AddObjects(std::span<const CopySummary> copies, TemplateVariables& variables) {
  // Start G-code may print it, outside of any comment.
  const std::string name = copies.empty() ? "" : CommentLine(copies.front().name.object_name);
  variables["num_objects"] = variables["num_instances"] = {static_cast<int64_t>(copies.size())};
  variables["input_filename"] = {name};
  variables["input_filename_base"] = {name.substr(0, name.rfind('.'))};
}

}  // namespace

TemplateVariables LayerVariables(const MotionOptions& options, const JobFacts& facts,
                                 const LayerPlace& place) {
  TemplateVariables variables = SettingVariables(options, options.layer_settings);
  AddLayer(place, variables);
  if (facts.layer_count > 0) variables["total_layer_count"] = {int64_t{facts.layer_count}};
  return variables;
}

TemplateVariables ProgramVariables(const MotionOptions& options, const ProgramSummary& summary,
                                   double time_s) {
  TemplateVariables variables = SettingVariables(options, summary.settings_text);
  AddLayer(LastPlace(summary), variables);
  variables["total_layer_count"] = {static_cast<int64_t>(summary.layers.size())};
  AddBox("first_layer_print", summary.total.bounds, variables);
  AddUse(options, summary.total, variables);
  AddTime(time_s, variables);
  AddObjects(summary.copies, variables);
  return variables;
}

}  // namespace slicefarm::motion
