#include "services/motion/algo/macro/template_variables.h"

#include <algorithm>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

#include "common/base/duration_text.h"
#include "common/base/shared/shared_text.h"
#include "common/geometry/measure.h"
#include "common/macro/setting_variables.h"
#include "common/model/layers/filament_use.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/text/comment_text.h"
#include "services/motion/algo/toolpath/footprint.h"

namespace slicefarm::motion {
namespace {

using macro::TemplateValue;
using macro::TemplateVariable;
using macro::TemplateVariables;

/// Returns the values that the stage itself uses.
TemplateVariables OptionVariables(const MotionOptions& options) {
  TemplateVariables variables;
  const auto put = [&](const char* name, TemplateValue value) {
    variables[name] = macro::OneOfSetting(name, std::move(value));
  };
  const auto whole = [&](const char* name, int64_t value) { put(name, value); };
  const auto real = [&](const char* name, double value) { put(name, value); };
  const auto text = [&](const char* name, const std::string& value) { put(name, value); };
  whole("temperature", options.tool().temperature_c);
  whole("first_layer_temperature", options.tool().first_layer_temperature_c);
  whole("bed_temperature", options.tool().bed_temperature_c);
  whole("first_layer_bed_temperature", options.tool().first_layer_bed_temperature_c);
  real("nozzle_diameter", options.tool().nozzle_diameter_mm);
  real("filament_diameter", options.tool().filament_diameter_mm);
  real("filament_density", options.tool().filament_density_g_cm3);
  real("filament_cost", options.tool().filament_cost_per_kg);
  real("extrusion_multiplier", options.tool().extrusion_multiplier);
  text("filament_type", options.tool().filament_type);
  text("filament_colour", options.tool().filament_colour);
  text("filament_settings_id", options.tool().filament_settings_id);
  text("printer_model", options.printer_model);
  text("gcode_flavor", std::string(FirmwareOf(options.flavor).name()));
  real("z_offset", options.z_offset_mm);
  real("travel_speed", options.travel_speed_mm_s);
  real("retract_length", options.tool().retraction.length_mm);
  real("retract_lift", options.tool().retraction.lift_mm);
  real("retract_speed", options.tool().retraction.speed_mm_s);
  whole("min_fan_speed", options.tool().cooling.min_fan_percent);
  whole("max_fan_speed", options.tool().cooling.max_fan_percent);
  whole("bridge_fan_speed", options.tool().cooling.bridge_fan_percent);
  return variables;
}

TemplateVariable Pair(Point point) {
  const auto mm = [](Coord nm) { return ToMm(static_cast<double>(nm)); };
  return TemplateVariable::List({mm(point.x), mm(point.y)});
}

/// Adds name_min, name_max and name_size, in mm.
void AddBox(const std::string& name, const Box& box, TemplateVariables& variables) {
  const Point min = box.Empty() ? Point{} : box.min;
  const Point max = box.Empty() ? Point{} : box.max;
  variables[name + "_min"] = Pair(min);
  variables[name + "_max"] = Pair(max);
  variables[name + "_size"] = Pair(max - min);
}

/// Adds the corners, each as "10,20".
void AddHull(const Polygon& hull, TemplateVariables& variables) {
  std::vector<TemplateValue> items;
  for (const Point point : hull) {
    const TemplateVariable pair = Pair(point);
    items.push_back(macro::ToText(pair.items[0]) + "," + macro::ToText(pair.items[1]));
  }
  variables["first_layer_print_convex_hull"] = TemplateVariable::List(std::move(items));
}

void AddTime(double time_s, double silent_s, TemplateVariables& variables) {
  const auto whole = static_cast<int64_t>(time_s);
  constexpr int64_t kMinute = 60, kHour = 60 * kMinute, kDay = 24 * kHour;
  variables["print_time_total_sec"] = whole;
  variables["print_time_day"] = whole / kDay;
  variables["print_time_hour"] = whole % kDay / kHour;
  variables["print_time_minute"] = whole % kHour / kMinute;
  variables["print_time_sec"] = whole % kMinute;
  variables["print_time"] = variables["normal_print_time"] = DurationText(time_s);
  variables["silent_print_time"] = DurationText(silent_s);
}

void AddObjects(std::span<const CopySummary> copies, TemplateVariables& variables) {
  // Start G-code may print the name outside a comment.
  const std::string name = copies.empty() ? "" : CommentLine(copies.front().name.object_name);
  variables["num_objects"] = variables["num_instances"] = static_cast<int64_t>(copies.size());
  const std::string base = name.substr(0, name.rfind('.'));
  variables["model_name"] = name;
  variables["input_filename_base"] = base;
  // PrusaSlicer's value is the name of its output file.
  variables["input_filename"] = base + ".gcode";
  variables["scale"] = TemplateVariable::List({std::string("x:100% y:100% z:100%")});
}

void AddUse(const MotionOptions& options, const ProgramStats& total, double time_s,
            TemplateVariables& variables) {
  const FilamentUse use = FilamentUseOf(total, options);
  variables["used_filament"] = use.length_mm / 1000;
  variables["used_filament_length"] = use.length_mm;
  variables["total_weight"] = use.mass_g;
  variables["total_cost"] = use.cost + PrinterCost(options, time_s);
  variables["total_wipe_tower_cost"] = variables["total_wipe_tower_filament"] = 0.0;
}

/// Returns the use of a length of filament.
FilamentUse UseOf(const MotionOptions& options, double filament_mm) {
  ProgramStats stats;
  const double radius_mm = options.tool().filament_diameter_mm / 2;
  stats.features[0].filament_mm = filament_mm;
  stats.features[0].volume_mm3 = filament_mm * std::numbers::pi * radius_mm * radius_mm;
  return FilamentUseOf(stats, options);
}

/// Returns the acceleration along y, in mm/s^2, that the machine reaches with a print on its bed.
/// An empty bed has the machine's own limit, as in Bambu Studio.
double AccelerationY(const MotionOptions& options, double print_mass_g) {
  const double limit_mm_s2 = options.limits.max_acceleration_mm_s2[1];
  const auto& [force_n, bed_mass_g, most] = options.bed_motor;
  if (force_n <= 0 || print_mass_g <= 0) return limit_mm_s2;
  constexpr double kMmGramsPerNewton = 1e6;  // N / g in mm/s^2
  return std::min(limit_mm_s2, kMmGramsPerNewton * force_n / (bed_mass_g + print_mass_g));
}

}  // namespace

TemplateVariables JobVariables(const MotionOptions& options, std::string_view settings_text) {
  TemplateVariables variables = OptionVariables(options);
  macro::AddSettingVariables(settings_text, variables);
  return variables;
}

TemplateVariables LayerVariables(const LayerContext& context, const JobFacts& facts) {
  const double z_mm = ToMm(static_cast<double>(context.print_z_nm));
  TemplateVariables variables;
  variables["current_object_idx"] = int64_t{context.pass};
  variables["layer_num"] = int64_t{context.number};
  variables["layer_z"] = variables["toolchange_z"] = z_mm;
  variables["max_layer_z"] = ToMm(static_cast<double>(context.top_nm));
  if (facts.layer_count > 0) variables["total_layer_count"] = int64_t{facts.layer_count};
  return variables;
}

TemplateVariables PrintVariables(const MotionOptions& options, const ProgramSummary& summary,
                                 double time_s, std::optional<double> silent_s) {
  TemplateVariables variables;
  variables["total_layer_count"] = static_cast<int64_t>(summary.layers.size());
  const Polygon first_layer = FirstLayerHull(summary);
  const Box box = Bounds(first_layer);
  AddBox("first_layer_print", box, variables);
  variables["first_layer_center_no_wipe_tower"] =
      Pair(box.Empty() ? Point{} : Point{(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2});
  variables["max_print_z"] = ToMm(static_cast<double>(TopOf(summary)));
  AddHull(first_layer, variables);
  AddUse(options, summary.total, time_s, variables);
  AddTime(time_s, silent_s.value_or(time_s), variables);
  AddObjects(summary.copies, variables);
  variables["position"] = TemplateVariable::List({0.0, 0.0, 0.0});
  variables["e_retracted"] = TemplateVariable::List({0.0});
  return variables;
}

void PutUseSoFar(const MotionOptions& options, double filament_mm, double layer_mm,
                 TemplateVariables& variables) {
  const FilamentUse use = UseOf(options, filament_mm);
  variables["extruded_volume"] = TemplateVariable::List({use.volume_mm3});
  variables["extruded_weight"] = TemplateVariable::List({use.mass_g});
  variables["extruded_volume_total"] = use.volume_mm3;
  variables["extruded_weight_total"] = use.mass_g;
  variables["curr_accumulated_mass"] = use.mass_g;
  variables["curr_layer_mass"] = UseOf(options, layer_mm).mass_g;
  variables["curr_y_acceleration_limit"] = AccelerationY(options, use.mass_g);
}

}  // namespace slicefarm::motion
