#include <numbers>
#include <utility>

#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

/// Value of fill_pattern = auto, which is not a pattern.
constexpr int kAutoPattern = kFillPatternCount;

std::vector<Choice> SparsePatterns() {
  std::vector<Choice> choices;
  for (const FillPatternInfo& info : kFillPatterns)
    if (info.sparse) choices.push_back({info.name, static_cast<int>(info.pattern)});
  choices.push_back({"auto", kAutoPattern});
  return choices;
}

void SetPattern(InfillOptions& infill, const Value& value) {
  infill.choose_pattern = value.number == kAutoPattern;
  infill.pattern = infill.choose_pattern ? InfillOptions{}.pattern
                                         : static_cast<FillPattern>(std::lround(value.number));
}

Value PatternOf(const InfillOptions& infill) {
  return {.number = infill.choose_pattern ? kAutoPattern : static_cast<double>(infill.pattern)};
}

SettingSpec AnglesByLayer(std::string_view key, std::string_view doc, Field field) {
  return {.key = key, .kind = Kind::kAngles, .standard = "", .doc = doc, .field = field};
}

SettingSpec SolidFill(std::string_view key, std::string_view standard, std::string_view doc,
                      Field field) {
  std::vector<Choice> choices;
  for (const FillPatternInfo& info : kFillPatterns)
    if (info.solid != SolidFillStyle::kNone)
      choices.push_back({info.name, static_cast<int>(info.pattern)});
  return {.key = key,
          .kind = Kind::kChoice,
          .standard = standard,
          .doc = doc,
          .choices = std::move(choices),
          .field = field};
}

/// Returns a field for the number of solid layers that the setting requests. It excludes layers
/// added for the thickness (shells.h).
template <int32_t InfillOptions::*kLayers, ShellExtra InfillOptions::*kSpare>
Field LayersField() {
  return Convert<RegionRow>(
      [](RegionRow& row, const Value& value) {
        row.infill.*kLayers = static_cast<int32_t>(value.number);
      },
      [](const RegionRow& row) {
        const int32_t asked = row.infill.*kLayers - (row.infill.*kSpare).layers;
        return Value{.number = static_cast<double>(asked)};
      });
}

SettingSpec SolidLayers(std::string_view key, std::string_view doc, Field field) {
  return {.key = key,
          .kind = Kind::kInteger,
          .min = 0,
          .max = 1000,
          .standard = "3",
          .doc = doc,
          .field = field};
}

SettingSpec BridgeDensity(std::string_view key, double max, std::string_view doc, Field field) {
  return {.key = key,
          .kind = Kind::kPercent,
          .unit = "%",
          .min = 10,
          .max = max,
          .standard = "100%",
          .doc = doc,
          .field = field};
}

SettingSpec MinThickness(std::string_view key, std::string_view doc) {
  return {.key = key,
          .unit = "mm",
          .min = 0,
          .max = 1000,
          .standard = "0",
          .doc = doc,
          .own_scope = Scope::kRegion};
}

}  // namespace

std::vector<SettingSpec> InfillSettings() {
  std::vector<SettingSpec> settings = {
      Orca({"top_shell_layers"},
           SolidLayers("top_solid_layers", "Number of solid layers at a top surface; 0: none",
                       LayersField<&InfillOptions::top_solid_layers, &InfillOptions::top_spare>())),
      Orca({"bottom_shell_layers"},
           SolidLayers(
               "bottom_solid_layers", "Number of solid layers at a bottom surface; 0: none",
               LayersField<&InfillOptions::bottom_solid_layers, &InfillOptions::bottom_spare>())),
      Orca({"top_shell_thickness"},
           MinThickness("top_solid_min_thickness",
                        "Smallest thickness of the top shell: solid layers are added to "
                        "top_solid_layers until the shell is this thick; 0: no layers are added")),
      Orca({"bottom_shell_thickness"},
           MinThickness(
               "bottom_solid_min_thickness",
               "Smallest thickness of the bottom shell: solid layers are added to "
               "bottom_solid_layers until the shell is this thick; 0: no layers are added")),
      {.key = "fill_density",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "20%",
       .doc = "Share of the part's inside that sparse infill fills; 100%: solid",
       .field = Bind<Scale::kPercent, &RegionRow::infill, &InfillOptions::density>(),
       .orca = {{"sparse_infill_density", OrcaValue::kPercent}},
       .needs = {&needs::kNoDensityField}},
      {.key = "fill_pattern",
       .kind = Kind::kChoice,
       .standard = "grid",
       .doc = "Pattern of the sparse infill; auto: chosen for each object by fill_density, the "
              "object's size and infill_goal",
       .choices = SparsePatterns(),
       .field = Convert<RegionRow>(
           [](RegionRow& row, const Value& value) { SetPattern(row.infill, value); },
           [](const RegionRow& row) { return PatternOf(row.infill); }),
       .orca = {{"sparse_infill_pattern", OrcaValue::kChoice}},
       .needs = {&needs::kNoStressField}},
      {.key = "infill_goal",
       .kind = Kind::kChoice,
       .standard = "strength",
       .doc = "Aim of fill_pattern = auto. strength: a strong part. time: a short print time. "
              "flexibility: a flexible part",
       .choices = {{"strength", static_cast<int>(FillGoal::kStrength)},
                   {"time", static_cast<int>(FillGoal::kTime)},
                   {"flexibility", static_cast<int>(FillGoal::kFlexibility)}},
       .field = Bind<&RegionRow::infill, &InfillOptions::goal>(),
       .needs = {&needs::kAutoPattern}},
      Orca({"internal_solid_infill_pattern", OrcaValue::kChoice},
           SolidFill("solid_fill_pattern", "rectilinear",
                     "Pattern of solid infill that is not visible, inside the part",
                     Bind<&RegionRow::infill, &InfillOptions::solid_pattern>())),
      Orca({"top_surface_pattern", OrcaValue::kChoice},
           SolidFill("top_fill_pattern", "monotonic", "Pattern of top surfaces",
                     Bind<&RegionRow::infill, &InfillOptions::top_pattern>())),
      Orca({"bottom_surface_pattern", OrcaValue::kChoice},
           SolidFill("bottom_fill_pattern", "monotonic", "Pattern of bottom surfaces",
                     Bind<&RegionRow::infill, &InfillOptions::bottom_pattern>())),
      {.key = "fill_angle",
       .unit = "degrees",
       .min = 0,
       .max = 360,
       .standard = "45",
       .doc = "Direction of infill lines, from the x axis; solid infill turns by 90 degrees from "
              "layer to layer, sparse infill as fill_pattern requires",
       .field = Bind<Scale::kDegrees, &RegionRow::infill, &InfillOptions::angle_rad>(),
       .orca = {{"infill_direction"}}},
      {.key = "solid_fill_angle",
       .unit = "degrees",
       .min = -1,
       .max = 360,
       .standard = "-1",
       .doc = "Direction of solid infill lines in every second layer, from the x axis; the other "
              "layers are perpendicular. -1: fill_angle",
       .field = Convert<RegionRow>(
           [](RegionRow& row, const Value& value) {
             row.infill.solid_angle_rad =
                 value.number < 0 ? -1 : value.number * std::numbers::pi / 180;
           },
           [](const RegionRow& row) {
             const double angle_rad = row.infill.solid_angle_rad;
             return Value{.number =
                              angle_rad < 0 ? -1 : Quantise(angle_rad * 180 / std::numbers::pi)};
           }),
       .orca = {{"solid_infill_direction"}}},
      Orca({"sparse_infill_rotate_template"},
           AnglesByLayer("fill_angle_template",
                         "Directions of sparse infill lines in degrees, a list that repeats over "
                         "the layers. 0,90: alternating. 45#2,0: 45 degrees in two layers, then 0 "
                         "in one. +30: 30 degrees more in each layer. Empty: fill_angle",
                         Bind<&RegionRow::infill, &InfillOptions::angle_template>())),
      Orca({"solid_infill_rotate_template"},
           AnglesByLayer(
               "solid_fill_angle_template",
               "Directions of solid infill lines by layer, written as in fill_angle_template; "
               "bridges keep their own direction. Empty: solid_fill_angle",
               Bind<&RegionRow::infill, &InfillOptions::solid_angle_template>())),
      {.key = "infill_overlap",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "25%",
       .doc = "Length by which infill lines overlap the innermost wall",
       .relative_to = "perimeter_extrusion_width",
       .field = Bind<&RegionRow::infill, &InfillOptions::overlap_nm>(),
       .orca = {{"infill_wall_overlap", OrcaValue::kPercent}}},
      {.key = "top_bottom_infill_overlap",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = -1,
       .max = 5,
       .standard = "-1",
       .doc = "Length by which lines of top and bottom surfaces overlap the innermost wall; -1: "
              "infill_overlap",
       .relative_to = "perimeter_extrusion_width",
       .field = Convert<RegionRow>(
           [](RegionRow& row, const Value& value) {
             row.infill.surface_overlap_nm = value.number < 0 ? -1 : FromMm(value.number);
           },
           [](const RegionRow& row) {
             const Coord overlap = row.infill.surface_overlap_nm;
             return Value{.number = overlap < 0 ? -1 : Quantise(ToMm(overlap))};
           }),
       .orca = {{"top_bottom_infill_wall_overlap", OrcaValue::kPercent}}},
      {.key = "infill_anchor",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "600%",
       .doc = "Length by which a sparse infill line without a connection to another line is "
              "extended along the wall; 0: not extended",
       .relative_to = "infill_extrusion_width",
       .field = Bind<&RegionRow::infill, &InfillOptions::anchor_nm>(),
       .orca = {{"infill_anchor"}}},
      {.key = "infill_anchor_max",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "50",
       .doc =
           "Longest piece along the wall that connects two sparse infill lines; 0: no connections. "
           "Connections are thinner than infill lines, so that the density remains fill_density",
       .relative_to = "infill_extrusion_width",
       .field = Bind<&RegionRow::infill, &InfillOptions::anchor_max_nm>(),
       .orca = {{"infill_anchor_max"}}},
      {.key = "infill_smoothing",
       .unit = "mm",
       .min = 0,
       .max = 10,
       .standard = "0",
       .doc = "Smoothing of the lines of fill_pattern = medialaxis: details shorter than about six "
              "times this length disappear; 0: no smoothing",
       .field = Bind<&RegionRow::infill, &InfillOptions::smoothing_nm>(),
       .needs = {&needs::kMedialAxis}},
      {.key = "solid_infill_every_layers",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 1000000,
       .standard = "0",
       .doc = "Interval of layers that have solid instead of sparse infill; 10: every 10th layer. "
              "0: no such layers",
       .field = Bind<&RegionRow::infill, &InfillOptions::solid_every_layers>()},
      {.key = "bridge_angle",
       .unit = "degrees",
       .min = 0,
       .max = 360,
       .standard = "0",
       .doc = "Direction of bridge lines, from the x axis; 0: the best supported direction of each "
              "bridge",
       .field = Bind<Scale::kDegrees, &RegionRow::infill, &InfillOptions::bridge_angle_rad>(),
       .orca = {{"bridge_angle"}}},
      {.key = "bridge_flow_ratio",
       .min = 0.1,
       .max = 2,
       .standard = "1",
       .doc = "Factor for the flow of bridge lines. 1: strands as thick as the nozzle, or the flow "
              "of solid infill with thick_bridges = 0",
       .field = Bind<&RegionRow::infill, &InfillOptions::bridge_flow>(),
       .also = Bind<&RegionRow::motion, &RegionMotion::bridge_flow>(),
       .orca = {{"bridge_flow"}}},
      Orca({"bridge_density"},
           BridgeDensity(
               "bridge_density", 120,
               "Share of a bridge's area that its lines cover; 100%: no gaps between the lines. "
               "Above 100%: the lines overlap",
               Bind<Scale::kPercent, &RegionRow::infill, &InfillOptions::bridge_density>())),
      Orca({"internal_bridge_density"},
           BridgeDensity("internal_bridge_density", 100,
                         "Share of a bridge over sparse infill that its lines cover; 100%: no gaps "
                         "between the lines",
                         Bind<Scale::kPercent, &RegionRow::infill,
                              &InfillOptions::internal_bridge_density>())),
      {.key = "top_solid_infill_flow_ratio",
       .min = 0.1,
       .max = 2,
       .standard = "1",
       .doc = "Factor for the flow of top surfaces; 1: the flow of other solid infill",
       .field = Bind<&RegionRow::infill, &InfillOptions::top_flow>(),
       .orca = {{"top_solid_infill_flow_ratio"}}},
      {.key = "bottom_solid_infill_flow_ratio",
       .min = 0.1,
       .max = 2,
       .standard = "1",
       .doc = "Factor for the flow of bottom surfaces that are not bridges; 1: the flow of other "
              "solid infill",
       .field = Bind<&RegionRow::infill, &InfillOptions::bottom_flow>(),
       .orca = {{"bottom_solid_infill_flow_ratio"}}},
      {.key = "thick_bridges",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Print bridges as round strands as thick as the nozzle, which span longer gaps but "
              "hang below their layer; 0: as flat lines as high as the layer",
       .field = Bind<&RegionRow::infill, &InfillOptions::thick_bridges>(),
       .also = Bind<&RegionRow::motion, &RegionMotion::thick_bridges>(),
       .orca = {{"thick_bridges"}}},
      {.key = "internal_bridge_flow",
       .min = 0,
       .max = 2,
       .standard = "0",
       .doc = "Factor for the flow of bridges over sparse infill; 0: bridge_flow_ratio",
       .field = Bind<&RegionRow::infill, &InfillOptions::internal_bridge_flow>(),
       .also = Bind<&RegionRow::motion, &RegionMotion::internal_bridge_flow>(),
       .orca = {{"internal_bridge_flow"}}},
      {.key = "thick_internal_bridges",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Print bridges over sparse infill as round strands as thick as the nozzle; 0: as "
              "flat lines as high as the layer",
       .field = Bind<&RegionRow::infill, &InfillOptions::thick_internal_bridges>(),
       .orca = {{"thick_internal_bridges"}}},
      {.key = "automatic_infill_combination",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc =
           "Set infill_every_layers to the number of layers that fit into "
           "automatic_infill_combination_max_layer_height; 0: infill_every_layers is used as given",
       .own_scope = Scope::kRegion,
       .orca = {{"infill_combination"}}},
      {.key = "automatic_infill_combination_max_layer_height",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 10,
       .standard = "100%",
       .doc = "Largest height of sparse infill lines that are printed once for several layers; at "
              "most the nozzle diameter",
       .relative_to = "nozzle_diameter",
       .own_scope = Scope::kRegion,
       .orca = {{"infill_combination_max_layer_height"}},
       .needs = {&needs::kCombinedByHeight}},
      {.key = "infill_every_layers",
       .kind = Kind::kInteger,
       .min = 1,
       .max = 100,
       .standard = "1",
       .doc = "Number of layers that share one sparse infill. Its thicker lines are printed in the "
              "topmost of these layers only, at most as high as the nozzle diameter. 1: sparse "
              "infill in every layer",
       .field = Bind<&RegionRow::infill, &InfillOptions::every_layers>(),
       .needs = {&needs::kCombinedByNumber}},
      {.key = "interface_shells",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print solid layers also where regions with different settings, such as the region "
              "of a modifier, are on top of each other",
       .field = Bind<&RegionRow::infill, &InfillOptions::interface_shells>(),
       .own_scope = Scope::kObject,
       .orca = {{"interface_shells"}}},
      {.key = "small_area_infill_flow_compensation",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Reduce the flow of short solid infill lines by the factors in "
              "small_area_infill_flow_compensation_model",
       .field = Bind<&RegionRow::infill, &InfillOptions::small_area_flow>(),
       .orca = {{"small_area_infill_flow_compensation"}}},
      {.key = "small_area_infill_flow_compensation_model",
       .kind = Kind::kFlowTable,
       .standard = kSmallAreaFlowTable,
       .doc = "Flow factors of solid infill lines by their length in mm between two turns, "
              "interpolated: LENGTH,FACTOR;LENGTH,FACTOR and so on",
       .field = Bind<&RegionRow::infill, &InfillOptions::small_area_flow_table>(),
       .orca = {{"small_area_infill_flow_compensation_model", OrcaValue::kPairs}},
       .needs = {&needs::kSmallAreaFlow}},
      {.key = "infill_only_where_needed",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print sparse infill only where it supports a top surface above",
       .field = Bind<&RegionRow::infill, &InfillOptions::only_where_needed>()},
      {.key = "ensure_vertical_shell_thickness",
       .kind = Kind::kChoice,
       .standard = "enabled",
       .doc = "Add solid infill inside the walls of slopes, where the walls alone do not close the "
              "shell. enabled: everywhere. partial: where this infill is at least three lines "
              "wide, as on gentle slopes. disabled: none. 0 and 1 are older names of partial and "
              "enabled",
       .choices = {{"disabled", static_cast<int>(ShellThickness::kDisabled)},
                   {"partial", static_cast<int>(ShellThickness::kPartial)},
                   {"enabled", static_cast<int>(ShellThickness::kEnabled)},
                   {"0", static_cast<int>(ShellThickness::kPartial)},
                   {"1", static_cast<int>(ShellThickness::kEnabled)}},
       .field = Bind<&RegionRow::infill, &InfillOptions::shells>(),
       .orca = {{"ensure_vertical_shell_thickness", OrcaValue::kChoice}}},
      {.key = "extra_perimeters_on_overhangs",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Fill overhangs that cannot be bridged with lines along the supported edge, starting "
              "at this edge; 0: like bridges",
       .field = Bind<&RegionRow::infill, &InfillOptions::overhang_lines>(),
       .orca = {{"extra_perimeters_on_overhangs"}}},
      {.key = "solid_infill_below_area",
       .unit = "mm2",
       .min = 0,
       .max = 1e6,
       .standard = "70",
       .doc = "Area below which an island of sparse infill becomes solid; 0: never",
       .field = Bind<&RegionRow::infill, &InfillOptions::solid_below_area_mm2>(),
       .orca = {{"minimum_sparse_infill_area"}}},
      {.key = "density_field",
       .kind = Kind::kDensityField,
       .standard = "",
       .doc = "Density of the sparse infill by position; replaces fill_density. Empty: "
              "fill_density everywhere",
       .field = Bind<&RegionRow::infill, &InfillOptions::density_field>()},
      {.key = "stress_field",
       .kind = Kind::kStressField,
       .standard = "",
       .doc = "Stresses in the part by position. The lines of the sparse infill follow the "
              "directions of the principal stresses instead of fill_pattern. Empty: fill_pattern",
       .field = Bind<&RegionRow::infill, &InfillOptions::stress_field>()},
      {.key = "infill_first",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print infill before walls",
       .field = Bind<&MachineRow::order, &JobOrder::infill_first>(),
       .orca = {{"is_infill_first"}}},
  };
  for (const auto& section : {IroningSettings, PatternSettings, SolidSettings, SurfaceSettings})
    for (SettingSpec& spec : section()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
