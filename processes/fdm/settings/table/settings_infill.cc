#include <utility>

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

SettingSpec AnglesByLayer(std::string_view key, std::string_view of, Field field) {
  return {.key = key, .kind = Kind::kAngles, .standard = "", .doc = of, .field = field};
}

std::vector<SettingSpec> IroningSettings() {
  return {
      {.key = "ironing",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Smooths surfaces by going over them once more with little plastic",
       .field = Bind<&RegionRow::infill, &InfillOptions::ironing, &IroningOptions::enabled>(),
       .orca = {{"ironing_type", OrcaValue::kChoice}}},
      {.key = "ironing_type",
       .kind = Kind::kChoice,
       .standard = "top",
       .doc = "What is ironed: all top surfaces, those of the last layer, or all solid infill",
       .choices = {{"top", static_cast<int>(IroningType::kTop)},
                   {"topmost", static_cast<int>(IroningType::kTopmost)},
                   {"solid", static_cast<int>(IroningType::kSolid)}},
       .field = Bind<&RegionRow::infill, &InfillOptions::ironing, &IroningOptions::type>(),
       .orca = {{"ironing_type", OrcaValue::kChoice}}},
      {.key = "ironing_flowrate",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "15%",
       .doc = "Plastic of ironing, of what would fill the layer",
       .field = Bind<Scale::kPercent, &RegionRow::infill, &InfillOptions::ironing,
                     &IroningOptions::flow>(),
       .orca = {{"ironing_flow", OrcaValue::kPercent}}},
      {.key = "ironing_spacing",
       .unit = "mm",
       .min = 0.01,
       .max = 10,
       .standard = "0.1",
       .doc = "Distance of the lines of ironing",
       .field = Bind<&RegionRow::infill, &InfillOptions::ironing, &IroningOptions::spacing_nm>(),
       .orca = {{"ironing_spacing"}}},
  };
}

SettingSpec SolidFill(std::string_view key, std::string_view standard, std::string_view doc,
                      Field field) {
  std::vector<Choice> choices;
  for (const FillPatternInfo& info : kFillPatterns)
    if (info.solid != SolidWay::kNone)
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
template <int32_t InfillOptions::*kLayers, SkinSpare InfillOptions::*kSpare>
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
           SolidLayers("top_solid_layers", "Number of solid layers under a top surface",
                       LayersField<&InfillOptions::top_solid_layers, &InfillOptions::top_spare>())),
      Orca({"bottom_shell_layers"},
           SolidLayers(
               "bottom_solid_layers", "Number of solid layers over a bottom surface",
               LayersField<&InfillOptions::bottom_solid_layers, &InfillOptions::bottom_spare>())),
      Orca({"top_shell_thickness"},
           MinThickness("top_solid_min_thickness",
                        "Makes top_solid_layers more until they are this thick; not if it is 0")),
      Orca(
          {"bottom_shell_thickness"},
          MinThickness("bottom_solid_min_thickness",
                       "Makes bottom_solid_layers more until they are this thick; not if it is 0")),
      {.key = "fill_density",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "20%",
       .doc = "How much of the inside is filled; 100%: solid",
       .field = Bind<Scale::kPercent, &RegionRow::infill, &InfillOptions::density>(),
       .orca = {{"sparse_infill_density", OrcaValue::kPercent}}},
      {.key = "fill_pattern",
       .kind = Kind::kChoice,
       .standard = "grid",
       .doc = "Pattern of the sparse infill; auto: by density, the part's thickness and "
              "infill_goal",
       .choices = SparsePatterns(),
       .field = Convert<RegionRow>(
           [](RegionRow& row, const Value& value) { SetPattern(row.infill, value); },
           [](const RegionRow& row) { return PatternOf(row.infill); }),
       .orca = {{"sparse_infill_pattern", OrcaValue::kChoice}}},
      {.key = "infill_goal",
       .kind = Kind::kChoice,
       .standard = "strength",
       .doc = "What the pattern that fill_pattern = auto chooses is to be good for",
       .choices = {{"strength", static_cast<int>(FillGoal::kStrength)},
                   {"time", static_cast<int>(FillGoal::kTime)},
                   {"flexibility", static_cast<int>(FillGoal::kFlexibility)}},
       .field = Bind<&RegionRow::infill, &InfillOptions::goal>()},
      Orca({"internal_solid_infill_pattern", OrcaValue::kChoice},
           SolidFill(
               "solid_fill_pattern", "rectilinear",
               "Pattern of the solid infill inside a part, where the order of lines is not seen",
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
       .doc = "Direction of the infill's lines; solid layers turn by a right angle each",
       .field = Bind<Scale::kDegrees, &RegionRow::infill, &InfillOptions::angle_rad>(),
       .orca = {{"infill_direction"}}},
      Orca({"sparse_infill_rotate_template"},
           AnglesByLayer(
               "fill_angle_template",
               "Direction of the sparse infill's lines by layer, in place of fill_angle: 0,90 "
               "or 45#2,0 for angles, +30 for turns from layer to layer",
               Bind<&RegionRow::infill, &InfillOptions::angle_template>())),
      Orca({"solid_infill_rotate_template"},
           AnglesByLayer("solid_fill_angle_template",
                         "The same for solid infill; bridges have their own direction",
                         Bind<&RegionRow::infill, &InfillOptions::solid_angle_template>())),
      {.key = "infill_overlap",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "25%",
       .doc = "How far the infill's lines reach into the walls",
       .relative_to = "perimeter_extrusion_width",
       .field = Bind<&RegionRow::infill, &InfillOptions::overlap_nm>(),
       .orca = {{"infill_wall_overlap", OrcaValue::kPercent}}},
      {.key = "infill_anchor",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "600%",
       .doc = "How far a line of sparse infill that is not linked to another one turns along the "
              "wall; 0: not at all",
       .relative_to = "infill_extrusion_width",
       .field = Bind<&RegionRow::infill, &InfillOptions::anchor_nm>(),
       .orca = {{"infill_anchor"}}},
      {.key = "infill_anchor_max",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "50",
       .doc = "Longest link along the wall between two lines of sparse infill; 0: none. Links are "
              "thinner than lines, so that the density stays what fill_density asks for",
       .relative_to = "infill_extrusion_width",
       .field = Bind<&RegionRow::infill, &InfillOptions::anchor_max_nm>(),
       .orca = {{"infill_anchor_max"}}},
      {.key = "infill_smoothing",
       .unit = "mm",
       .min = 0,
       .max = 10,
       .standard = "0",
       .doc = "Rounds the lines of fill_pattern = medialaxis: what is shorter than some six times "
              "this is smoothed away; 0: not at all",
       .field = Bind<&RegionRow::infill, &InfillOptions::smoothing_nm>()},
      {.key = "solid_infill_every_layers",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 1000000,
       .standard = "0",
       .doc = "Each layer whose number is a multiple of this becomes solid; 0: none",
       .field = Bind<&RegionRow::infill, &InfillOptions::solid_every_layers>()},
      {.key = "bridge_angle",
       .unit = "degrees",
       .min = 0,
       .max = 360,
       .standard = "0",
       .doc = "Direction of bridges' lines; 0: for each bridge the one in which it is borne best",
       .field = Bind<Scale::kDegrees, &RegionRow::infill, &InfillOptions::bridge_angle_rad>(),
       .orca = {{"bridge_angle"}}},
      {.key = "bridge_flow_ratio",
       .min = 0.1,
       .max = 2,
       .standard = "1",
       .doc = "Plastic of bridges' lines, of what lines of their width and layer have",
       .field = Bind<&RegionRow::infill, &InfillOptions::bridge_flow>(),
       .also = Bind<&RegionRow::motion, &RegionSpeeds::bridge_flow>(),
       .orca = {{"bridge_flow"}}},
      {.key = "top_solid_infill_flow_ratio",
       .min = 0.1,
       .max = 2,
       .standard = "1",
       .doc = "Flow of top surfaces relative to other solid infill; 1: the same",
       .field = Bind<&RegionRow::infill, &InfillOptions::top_flow>(),
       .orca = {{"top_solid_infill_flow_ratio"}}},
      {.key = "thick_bridges",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Prints bridges as round threads as wide as the nozzle, which span more and hang "
              "lower than their layer",
       .field = Bind<&RegionRow::infill, &InfillOptions::thick_bridges>(),
       .also = Bind<&RegionRow::motion, &RegionSpeeds::thick_bridges>(),
       .orca = {{"thick_bridges"}}},
      {.key = "automatic_infill_combination",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Takes for infill_every_layers as many layers as "
              "automatic_infill_combination_max_layer_height allows",
       .own_scope = Scope::kRegion,
       .orca = {{"infill_combination"}}},
      {.key = "automatic_infill_combination_max_layer_height",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 10,
       .standard = "100%",
       .doc = "Highest bead that automatic_infill_combination makes; never higher than the "
              "nozzle is wide",
       .relative_to = "nozzle_diameter",
       .own_scope = Scope::kRegion},
      {.key = "infill_every_layers",
       .kind = Kind::kInteger,
       .min = 1,
       .max = 100,
       .standard = "1",
       .doc = "Prints the sparse infill of that many layers at once, where all of them have it, "
              "as far as the nozzle's diameter allows",
       .field = Bind<&RegionRow::infill, &InfillOptions::every_layers>()},
      {.key = "interface_shells",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Gives a region with settings of its own solid layers also where it lies on or under "
              "another one",
       .field = Bind<&RegionRow::infill, &InfillOptions::interface_shells>(),
       .own_scope = Scope::kObject,
       .orca = {{"interface_shells"}}},
      {.key = "small_area_infill_flow_compensation",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Gives short lines of solid infill less plastic, by "
              "small_area_infill_flow_compensation_model",
       .field = Bind<&RegionRow::infill, &InfillOptions::small_area_flow>(),
       .orca = {{"small_area_infill_flow_compensation"}}},
      {.key = "small_area_infill_flow_compensation_model",
       .kind = Kind::kFlowTable,
       .standard = kSmallAreaFlowTable,
       .doc = "Which part of its plastic a line of solid infill gets by its length, from turn to "
              "turn; in proportion between these lengths",
       .field = Bind<&RegionRow::infill, &InfillOptions::small_area_flow_table>(),
       .orca = {{"small_area_infill_flow_compensation_model", OrcaValue::kPairs}}},
      {.key = "infill_only_where_needed",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Leaves out sparse infill that has no top surface above it",
       .field = Bind<&RegionRow::infill, &InfillOptions::only_where_needed>()},
      {.key = "ensure_vertical_shell_thickness",
       .kind = Kind::kChoice,
       .standard = "enabled",
       .doc = "Solid infill behind the walls of slopes: of all; partial: of gentle ones, where it "
              "is three lines wide at least; or of none. 0 and 1 are older names of partial and "
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
       .doc = "Fills overhangs that bridges cannot span from what bears them outwards, each line "
              "beside the one before",
       .field = Bind<&RegionRow::infill, &InfillOptions::overhang_lines>(),
       .orca = {{"extra_perimeters_on_overhangs"}}},
      {.key = "solid_infill_below_area",
       .unit = "mm2",
       .min = 0,
       .max = 1e6,
       .standard = "70",
       .doc = "Regions of sparse infill smaller than this become solid",
       .field = Bind<&RegionRow::infill, &InfillOptions::solid_below_area_mm2>(),
       .orca = {{"minimum_sparse_infill_area"}}},
      {.key = "density_field",
       .kind = Kind::kDensityField,
       .standard = "",
       .doc = "How dense the sparse infill is, by place; fill_density then has no effect",
       .field = Bind<&RegionRow::infill, &InfillOptions::density_field>()},
      {.key = "stress_field",
       .kind = Kind::kStressField,
       .standard = "",
       .doc =
           "Stresses whose principal directions the lines of the sparse infill follow, in place of "
           "fill_pattern",
       .field = Bind<&RegionRow::infill, &InfillOptions::stress_field>()},
      {.key = "infill_first",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Prints the infill before the walls",
       .field = Bind<&MachineRow::order, &JobOrder::infill_first>(),
       .orca = {{"is_infill_first"}}},
  };
  for (SettingSpec& ironing : IroningSettings()) settings.push_back(std::move(ironing));
  return settings;
}

}  // namespace slicefarm::config::fdm
