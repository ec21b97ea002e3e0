#include "common/config/projects/orca_pairs.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "absl/strings/str_replace.h"
#include "common/base/text.h"
#include "common/config/table/setting_spec.h"
#include "common/config/table/value.h"

namespace slicefarm::config {
namespace {

std::optional<double> NumberOf(const OrcaLookup& given, std::string_view key) {
  const std::optional<std::string> text = given(key);
  return text ? ToNumber(Trim(*text)) : std::nullopt;
}

bool IsOn(const OrcaLookup& given, std::string_view key) { return given(key) == "1"; }

void AddAccelToDecel(const OrcaLookup& given, std::vector<PairedSetting>& settings) {
  constexpr std::string_view kOn = "accel_to_decel_enable";
  const std::string share = given("accel_to_decel_factor").value_or("50%");
  if (const auto on = given(kOn))
    settings.push_back({"accel_to_decel", *on == "1" ? share : "0", kOn});
}

/// Adds a fan by layer times without slower printing: `cooling` is both, but no line is slowed down
/// below a least speed that is higher than the speed of all lines.
void AddFanWithoutSlowing(const OrcaLookup& given, std::vector<PairedSetting>& settings) {
  constexpr std::string_view kSlows = "slow_down_for_layer_cooling", kHighest = "1000";
  if (given(kSlows) != "0") return;
  settings.push_back({"cooling", "1", kSlows});
  settings.push_back({"min_print_speed", std::string(kHighest), kSlows});
}

/// Adds the flow of bottom surfaces, which the flow of internal solid infill does not change.
void AddBottomFlow(const OrcaLookup& given, std::vector<PairedSetting>& settings) {
  constexpr std::string_view kSolid = "internal_solid_infill_flow_ratio";
  constexpr std::string_view kBottom = "bottom_solid_infill_flow_ratio";
  const double solid = NumberOf(given, kSolid).value_or(1);
  if (!IsOn(given, "set_other_flow_ratios") || solid == 1 || solid <= 0) return;
  const double bottom = NumberOf(given, kBottom).value_or(1);
  settings.push_back({kBottom, PrintNumber(Quantise(bottom / solid)), kSolid});
}

void AddFlows(const OrcaLookup& given, std::vector<PairedSetting>& settings) {
  constexpr std::string_view kPrint = "print_flow_ratio", kFilament = "filament_flow_ratio";
  const double filament = NumberOf(given, kFilament).value_or(1);
  if (const auto print = NumberOf(given, kPrint); print && *print != 1)
    settings.push_back({"extrusion_multiplier", PrintNumber(Quantise(*print * filament)), kPrint});
  constexpr std::pair<std::string_view, std::string_view> kFlows[] = {
      {"first_layer_flow_ratio", "first_layer_flow_ratio"},
      {"outer_wall_flow_ratio", "external_perimeter_flow_ratio"},
      {"inner_wall_flow_ratio", "perimeter_flow_ratio"},
      {"overhang_flow_ratio", "overhang_flow_ratio"},
      {"sparse_infill_flow_ratio", "infill_flow_ratio"},
      {"internal_solid_infill_flow_ratio", "solid_infill_flow_ratio"},
      {"gap_fill_flow_ratio", "gap_fill_flow_ratio"},
      {"support_flow_ratio", "support_material_flow_ratio"},
      {"support_interface_flow_ratio", "support_material_interface_flow_ratio"}};
  const bool on = IsOn(given, "set_other_flow_ratios");
  for (const auto& [from, to] : kFlows)
    if (const auto ratio = given(from); ratio && on) settings.push_back({to, *ratio, from});
}

/// Adds the model of pressure advance, if pressure advance is on. OrcaSlicer's default model, two
/// points of zeros, is none.
void AddAdaptiveAdvance(const OrcaLookup& given, std::vector<PairedSetting>& settings) {
  constexpr std::string_view kOn = "adaptive_pressure_advance";
  constexpr std::string_view kModel = "adaptive_pressure_advance_model";
  constexpr std::string_view kNone = "0,0,0;0,0,0";
  const bool on = IsOn(given, kOn), any = IsOn(given, "enable_pressure_advance");
  const auto lines = given(kModel);
  if (!on || !any || !lines) return;
  const std::string model = absl::StrReplaceAll(*lines, {{"\\n", ";"}});
  settings.push_back({kOn, "1", kOn});
  settings.push_back({kModel, model == kNone ? "" : model, kModel});
}

/// Adds the ironing of the filament, which replaces that of the process.
void AddFilamentIroning(const OrcaLookup& given, std::vector<PairedSetting>& settings) {
  constexpr std::pair<std::string_view, std::string_view> kIroning[] = {
      {"filament_ironing_flow", "ironing_flowrate"},
      {"filament_ironing_spacing", "ironing_spacing"},
      {"filament_ironing_inset", "ironing_inset"},
      {"filament_ironing_speed", "ironing_speed"}};
  for (const auto& [from, to] : kIroning)
    if (const auto value = given(from); value && !value->empty() && *value != kNotSet)
      settings.push_back({to, *value, from});
}

/// Adds the diameter of the filament that has the pellets' flow.
void AddPellets(const OrcaLookup& given, std::vector<PairedSetting>& settings) {
  constexpr std::string_view kFlow = "pellet_flow_coefficient";
  const auto flow = NumberOf(given, kFlow);
  if (!IsOn(given, "pellet_modded_printer") || !flow || *flow <= 0) return;
  const double diameter_mm = std::sqrt(4 * *flow / std::numbers::pi);
  settings.push_back({"filament_diameter", PrintNumber(Quantise(diameter_mm)), kFlow});
}

/// Adds the number of walls of supports: 0 means no line around columns, and a second loop in
/// branches of more than 5 mm; from 2 on, all branches have a second loop.
void AddSupportWalls(const OrcaLookup& given, std::vector<PairedSetting>& settings) {
  constexpr std::string_view kCount = "tree_support_wall_count";
  constexpr std::string_view kNever = "100", kThick = "5", kAlways = "0";
  const auto count = NumberOf(given, kCount);
  if (!count) return;
  settings.push_back({"support_material_with_sheath", *count > 0 ? "1" : "0", kCount});
  settings.push_back({"support_tree_branch_diameter_double_wall",
                      std::string(*count >= 2   ? kAlways
                                  : *count >= 1 ? kNever
                                                : kThick),
                      kCount});
}

/// Adds the overhangs that supports of type tree leave out. Other types ignore these settings.
void AddTreeOverhangs(const OrcaLookup& given, std::vector<PairedSetting>& settings) {
  constexpr std::string_view kBridge = "max_bridge_length";
  constexpr std::string_view kCritical = "support_critical_regions_only";
  const auto longest = NumberOf(given, kBridge);
  const auto critical = given(kCritical);
  const std::string type = given("support_type").value_or("");
  if (!type.starts_with("tree") && !type.starts_with("hybrid")) return;
  if (longest) {
    settings.push_back({"dont_support_bridges", *longest > 0 ? "1" : "0", kBridge});
    settings.push_back({"support_material_max_bridge_length", PrintNumber(*longest), kBridge});
  }
  if (critical) settings.push_back({"support_material_critical_only", *critical, kCritical});
}

/// Adds the brim of branches, which styles without an own brim in OrcaSlicer do not have: organic
/// branches have raft_first_layer_expansion.
void AddTreeBrim(const OrcaLookup& given, std::vector<PairedSetting>& settings) {
  constexpr std::string_view kWidth = "tree_support_brim_width";
  const auto width = given(kWidth);
  const bool is_auto = given("tree_support_auto_brim").value_or("1") == "1";
  const std::string style = given("support_style").value_or("");
  const bool plain = style == "tree_slim" || style == "tree_strong" || style == "tree_hybrid";
  if (width && !is_auto && plain)
    settings.push_back({"raft_first_layer_expansion", *width, kWidth});
}

}  // namespace

std::vector<PairedSetting> PairedSettingsOf(const OrcaLookup& given) {
  std::vector<PairedSetting> settings;
  for (const auto add :
       {AddAccelToDecel, AddAdaptiveAdvance, AddBottomFlow, AddFanWithoutSlowing,
        AddFilamentIroning, AddFlows, AddPellets, AddSupportWalls, AddTreeOverhangs, AddTreeBrim})
    add(given, settings);
  return settings;
}

}  // namespace slicefarm::config
