#include "common/macro/setting_variables.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/base/text.h"
#include "common/macro/setting_types.h"
#include "common/macro/settings_text.h"
#include "common/macro/template_defaults.h"

namespace slicefarm::macro {
namespace {

using Of = SettingType::Of;

/// Limit of bed coordinates; corners beyond it are invalid.
constexpr double kFarthestMm = 10'000;
/// Maximum number of tools in PrusaSlicer.
constexpr size_t kMostTools = 255;

/// A setting in percent, and the setting that the percentage refers to.
struct Relation {
  std::string_view key;
  std::string_view of;
};
constexpr Relation kRelations[] = {
    {"external_perimeter_speed", "perimeter_speed"},
    {"first_layer_height", "layer_height"},
    {"infill_anchor", "infill_extrusion_width"},
    {"infill_anchor_max", "infill_extrusion_width"},
    {"infill_overlap", "perimeter_extrusion_width"},
    {"small_perimeter_speed", "perimeter_speed"},
    {"solid_infill_speed", "infill_speed"},
    {"support_material_interface_speed", "support_material_speed"},
    {"support_material_xy_spacing", "external_perimeter_extrusion_width"},
    {"top_solid_infill_speed", "solid_infill_speed"},
};

/// Different names of the same value.
constexpr Relation kAliases[] = {
    {"print_preset", "print_settings_id"},
    {"printer_preset", "printer_settings_id"},
    {"filament_preset", "filament_settings_id"},
    {"physical_printer_preset", "physical_printer_settings_id"},
    {"initial_filament_type", "filament_type"},
    {"printing_filament_types", "filament_type"},
};

constexpr std::array<std::string_view, 4> kOfALayer = {"layer_num", "layer_z", "max_layer_z",
                                                       "current_object_idx"};

constexpr std::array<std::string_view, 37> kWaiting = {
    "curr_accumulated_mass",
    "curr_layer_mass",
    "curr_y_acceleration_limit",
    "print_time_total_sec",
    "print_time_day",
    "print_time_hour",
    "print_time_minute",
    "print_time_sec",
    "used_filament_length",
    "first_layer_center_no_wipe_tower",
    "model_name",
    "max_print_z",
    "extruded_volume",
    "extruded_volume_total",
    "extruded_weight",
    "extruded_weight_total",
    "first_layer_print_convex_hull",
    "first_layer_print_max",
    "first_layer_print_min",
    "first_layer_print_size",
    "input_filename",
    "input_filename_base",
    "normal_print_time",
    "num_instances",
    "num_objects",
    "print_time",
    "random",
    "scale",
    "silent_print_time",
    "total_cost",
    "total_layer_count",
    "total_weight",
    "total_wipe_tower_cost",
    "total_wipe_tower_filament",
    "used_filament",
    "e_retracted",
    "position",
};

constexpr std::array<std::string_view, 9> kLists = {"first_layer_center_no_wipe_tower",
                                                    "extruded_volume",
                                                    "extruded_weight",
                                                    "first_layer_print_convex_hull",
                                                    "first_layer_print_max",
                                                    "first_layer_print_min",
                                                    "first_layer_print_size",
                                                    "position",
                                                    "scale"};

template <typename Names>
bool Has(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <typename Number>
std::optional<Number> Parse(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return number;
}

std::optional<double> Finite(std::string_view text) {
  const auto number = Parse<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// Returns a number if the item looks like one, otherwise a text.
TemplateValue Guessed(const std::string& item) {
  if (item == "nil") return Nil{};
  if (const auto whole = Parse<int64_t>(item)) return *whole;
  if (const auto number = Finite(item)) return *number;
  return item;
}

TemplateValue ItemValue(Of type, const std::string& item) {
  std::string_view text = item;
  switch (type) {
    case Of::kFlag:
      if (text == "0" || text == "1") return text == "1";
      break;
    case Of::kWhole:
      if (const auto whole = Parse<int64_t>(text)) return *whole;
      if (const auto number = Finite(text); number && std::abs(*number) < 1e15)
        return static_cast<int64_t>(*number);
      break;
    case Of::kNumber:
    case Of::kPercent:
    case Of::kNumberOrPercent:
      if (text.ends_with('%')) text.remove_suffix(1);
      if (const auto number = Finite(text)) return *number;
      break;
    default:
      return item;
  }
  return Guessed(item);
}

std::string EscapedText(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\n' || c == '\r') {
      escaped += c == '\n' ? "\\n" : "\\r";
      continue;
    }
    if (c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::vector<std::string> ItemsBy(SettingType type, std::string_view key, std::string_view value) {
  if (type.of == Of::kText) return SettingItems(key, value);
  if (!type.is_list) return {UnescapeSetting(value)};
  if (value.empty()) return {};
  std::vector<std::string> items;
  for (const std::string_view item : Split(value, ",")) items.emplace_back(Trim(item));
  return items;
}

TemplateVariable GuessedVariable(std::string_view key, std::string_view value) {
  TemplateVariable variable;
  for (const std::string& item : SettingItems(key, value)) {
    std::vector<TemplateValue> numbers;
    for (const std::string_view part : Split(item, ",")) {
      numbers.push_back(Guessed(std::string(part)));
      if (!std::holds_alternative<std::string>(numbers.back())) continue;
      numbers = {item};
      break;
    }
    std::ranges::move(numbers, std::back_inserter(variable.items));
  }
  variable.is_list = variable.items.size() > 1;
  return variable;
}

void AddLines(std::string_view text, TemplateVariables& variables) {
  for (const auto& [key, value] : SettingLines(text)) {
    if (!variables.contains(key)) variables.emplace(key, SettingVariable(key, value));
  }
}

/// Converts percentages to absolute values of the settings that they refer to.
void ResolvePercentages(TemplateVariables& variables) {
  for (const Relation& relation : kRelations) {
    const auto part = variables.find(relation.key);
    const auto whole = variables.find(relation.of);
    if (part == variables.end() || whole == variables.end()) continue;
    TemplateVariable& variable = part->second;
    if (variable.written.size() != 1 || !variable.written[0].ends_with('%')) continue;
    auto* const share = std::get_if<double>(&variable.items[0]);
    const TemplateValue* const of = ItemOf(whole->second, 0);
    const auto* const number = of == nullptr ? nullptr : std::get_if<double>(of);
    if (share != nullptr && number != nullptr) *share *= *number / 100;
  }
}

/// Adds the bounds of a bed such as "0x0,250x0,250x210" as print_bed_min, _max and _size, in mm.
void AddBed(std::string_view bed_shape, TemplateVariables& variables) {
  double least[2] = {kFarthestMm, kFarthestMm}, most[2] = {-kFarthestMm, -kFarthestMm};
  bool any = false;
  for (const std::string_view corner : Split(bed_shape, ",")) {
    const size_t cross = std::min(corner.find('x'), corner.size());
    const auto x = ToNumber(corner.substr(0, cross));
    const auto y = ToNumber(corner.substr(std::min(cross + 1, corner.size())));
    if (!x || !y || !(std::abs(*x) < kFarthestMm) || !(std::abs(*y) < kFarthestMm)) continue;
    any = true;
    const double at[2] = {*x, *y};
    for (const int i : {0, 1}) {
      least[i] = std::min(least[i], at[i]);
      most[i] = std::max(most[i], at[i]);
    }
  }
  if (!any) least[0] = least[1] = most[0] = most[1] = 0;
  variables["print_bed_min"] = TemplateVariable::List({least[0], least[1]});
  variables["print_bed_max"] = TemplateVariable::List({most[0], most[1]});
  variables["print_bed_size"] = TemplateVariable::List({most[0] - least[0], most[1] - least[1]});
}

/// Adds Bambu Studio's and OrcaSlicer's names of the filament in use, and of the one extruder and
/// nozzle that print it. `tool`: number of the filament, from 0. A hotend number of -1 means that
/// the hotend is not in a rack.
void AddBambuTools(int64_t tool, TemplateVariables& variables) {
  for (const char* name : {"initial_filament_id", "initial_no_support_filament_id",
                           "current_filament_id", "next_filament_id"})
    variables.try_emplace(name, tool);
  for (const char* name :
       {"first_filaments", "first_tools", "first_non_support_filaments", "first_non_support_tools"})
    variables.try_emplace(name, TemplateVariable::List({tool}));
  for (const char* name :
       {"curr_physical_extruder_id", "most_used_physical_extruder_id", "initial_extruder_id",
        "initial_no_support_extruder_id", "current_extruder_id", "next_extruder_id",
        "initial_nozzle_id", "initial_no_support_nozzle_id", "current_nozzle_id", "next_nozzle_id"})
    variables.try_emplace(name, int64_t{0});
  for (const char* name : {"current_hotend", "next_hotend", "initial_no_support_hotend"})
    variables.try_emplace(name, int64_t{-1});
  variables.try_emplace("first_non_support_hotend", TemplateVariable::List({int64_t{-1}}));
  variables.try_emplace("filament_map", TemplateVariable::List({int64_t{1}}));
  if (const auto nozzles = variables.find("nozzle_diameter"); nozzles != variables.end())
    variables.try_emplace("nozzle_diameter_at_nozzle_id", nozzles->second);
  variables.try_emplace("nozzle_volume_types", TemplateVariable::List({std::string("Standard")}));
}

/// Adds other variables of Bambu Studio and OrcaSlicer, for a plate with one filament.
void AddBambuNames(TemplateVariables& variables) {
  for (const char* name :
       {"bbl_bed_temperature_gcode", "has_tpu_in_first_layer", "hold_chamber_temp_for_flat_print",
        "in_head_wrap_detect_zone", "is_all_bbl_filament", "is_prime_tower_interface",
        "timelapse_inline_photo", "wipe_avoid_perimeter", "wipe_tower_center_pos_valid"})
    variables.try_emplace(name, false);
  for (const char* name : {"wipe_tower_center_pos_x", "wipe_tower_center_pos_y"})
    variables.try_emplace(name, 0.0);
  variables.try_emplace("max_additional_fan", int64_t{0});
  variables.try_emplace("plate_number", int64_t{1});
  variables.try_emplace("plate_name", std::string());
}

/// Adds the variables of the tool in use, which is number `extruder`, from 1.
void AddTool(TemplateVariables& variables) {
  int64_t tool = 0;
  if (const auto extruder = variables.find("extruder"); extruder != variables.end())
    if (const auto* number = std::get_if<int64_t>(&extruder->second.items[0])) tool = *number - 1;
  if (tool < 0 || tool >= static_cast<int64_t>(kMostTools)) tool = 0;
  for (const char* name : {"initial_extruder", "initial_tool", "current_extruder", "next_extruder",
                           "filament_extruder_id", "color_change_extruder"})
    variables[name] = tool;
  for (const char* name : {"toolchange_count", "total_toolchanges"}) variables[name] = int64_t{0};
  variables["previous_extruder"] = int64_t{-1};
  variables["num_printing_extruders"] = int64_t{1};
  variables.try_emplace("num_extruders", tool + 1);
  variables["extruder_count"] = variables["num_extruders"];
  std::vector<TemplateValue> used(kMostTools, false);
  used[static_cast<size_t>(tool)] = true;
  variables["is_extruder_used"] = TemplateVariable::List(std::move(used));
  variables["has_wipe_tower"] = false;
  AddBambuTools(tool, variables);
  AddBambuNames(variables);
  variables["has_single_extruder_multi_material_priming"] = false;
  variables["zhop"] = 0.0;
  variables["e_restart_extra"] = variables["e_position"] = TemplateVariable::List({0.0});
}

/// Splits a time such as "2026-11-25T10:37:01Z" into timestamp, year, month, ...
void AddClock(TemplateVariables& variables) {
  const auto created = variables.find("creation_time");
  if (created == variables.end()) return;
  const auto* text = std::get_if<std::string>(&created->second.items[0]);
  if (text == nullptr || text->size() < 19) return;
  std::string stamp;
  constexpr struct {
    const char* name;
    size_t at;
    size_t size;
  } kFields[] = {{"year", 0, 4},  {"month", 5, 2},   {"day", 8, 2},
                 {"hour", 11, 2}, {"minute", 14, 2}, {"second", 17, 2}};
  for (const auto& [name, at, size] : kFields) {
    const auto number = Parse<int64_t>(std::string_view(*text).substr(at, size));
    if (!number) return;
    absl::StrAppend(&stamp, text->substr(at, size), at == 8 ? "-" : "");
    variables[name] = *number;
  }
  variables["timestamp"] = stamp;
}

}  // namespace

TemplateVariable SettingVariable(std::string_view key, std::string_view value) {
  const auto type = TypeOfSetting(key);
  if (!type) return GuessedVariable(key, value);
  TemplateVariable variable;
  variable.is_list = type->is_list;
  for (const std::string& item : ItemsBy(*type, key, value)) {
    variable.items.push_back(ItemValue(type->of, item));
    const bool is_scalar_text = type->of == Of::kText && !type->is_list;
    variable.written.push_back(is_scalar_text ? EscapedText(item) : item);
  }
  return variable;
}

TemplateVariable OneOfSetting(std::string_view key, TemplateValue value) {
  TemplateVariable variable(std::move(value));
  const auto type = TypeOfSetting(key);
  variable.is_list = type && type->is_list;
  return variable;
}

void AddSettingVariables(std::string_view given, TemplateVariables& variables) {
  AddLines(given, variables);
  AddLines(TemplateDefaults(), variables);
  ResolvePercentages(variables);
  for (const Relation& alias : kAliases) {
    if (const auto found = variables.find(alias.of); found != variables.end())
      variables[std::string(alias.key)] = found->second;
  }
  if (const auto types = variables.find("filament_type"); types != variables.end()) {
    const TemplateValue* const first = ItemOf(types->second, 0);
    if (first != nullptr)
      variables["initial_filament_type"] = variables["printing_filament_types"] = *first;
  }
  for (const auto& [key, value] : SettingLines(given))
    if (key == "bed_shape") AddBed(value, variables);
  if (!variables.contains("print_bed_min")) AddBed("", variables);
  AddTool(variables);
  AddClock(variables);
}

TemplateVariables VariablesOfThePrint() {
  TemplateVariables variables;
  for (const std::string_view name : kOfALayer) variables[std::string(name)] = Unknown{};
  for (const std::string_view name : kWaiting) {
    if (name == "random") continue;
    variables[std::string(name)] = Has(kLists, name) || name == "e_retracted"
                                       ? TemplateVariable::List({Unknown{}, Unknown{}, Unknown{}})
                                       : TemplateVariable(Unknown{});
  }
  variables["toolchange_z"] = Unknown{};
  return variables;
}

bool WaitsForLayers(std::string_view variable) { return Has(kWaiting, variable); }

}  // namespace slicefarm::macro
