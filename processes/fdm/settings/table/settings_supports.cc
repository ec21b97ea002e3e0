#include "common/model/limits.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

constexpr double kMostLayers = limits::kMaxLayers;

std::vector<SettingSpec> Where() {
  const auto style = [](SupportStyle value) { return static_cast<int>(value); };
  return {
      {.key = "support_material",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Supports below what would hang in the air",
       .field = Bind([](auto& s) -> auto& { return s.planning.objects[0].support.on; })},
      {.key = "support_material_auto",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "By the threshold; 0: only where parts of the role support_enforcer ask for it",
       .field = Bind([](auto& s) -> auto& { return s.planning.objects[0].support.automatic; })},
      {.key = "support_material_style",
       .kind = Kind::kChoice,
       .standard = "grid",
       .doc = "Columns on whole cells of a grid, columns under what they carry alone (snug), or "
              "branches (organic)",
       .choices = {{"grid", style(SupportStyle::kGrid)},
                   {"snug", style(SupportStyle::kSnug)},
                   {"organic", style(SupportStyle::kTree)},
                   {"tree", style(SupportStyle::kTree)}},
       .field = Bind([](auto& s) -> auto& { return s.planning.objects[0].support.style; })},
      {.key = "support_material_threshold",
       .unit = "degrees",
       .min = 0,
       .max = 90,
       .standard = "0",
       .doc = "Sides that rise less steeply are supported, from level; 0: those that hang over by "
              "more than half of the outer wall's width",
       .field = Bind<Scale::kDegrees>(
           [](auto& s) -> auto& { return s.planning.objects[0].support.threshold_rad; })},
      {.key = "support_material_enforce_layers",
       .kind = Kind::kInteger,
       .unit = "layers",
       .min = 0,
       .max = kMostLayers,
       .standard = "0",
       .doc = "Lowest layers whose overhangs are supported whatever the threshold says",
       .field =
           Bind([](auto& s) -> auto& { return s.planning.objects[0].support.enforced_layers; })},
      {.key = "support_material_buildplate_only",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "No support stands on the part",
       .field = Bind([](auto& s) -> auto& { return s.planning.objects[0].support.bed_only; })},
      {.key = "dont_support_bridges",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "What spans from wall to wall is left without",
       .field = Bind([](auto& s) -> auto& { return s.planning.objects[0].support.skip_bridges; })},
      {.key = "support_material_contact_distance",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0.2",
       .doc = "From a support's top to the part",
       .field = Bind([](auto& s) -> auto& { return s.planning.objects[0].support.top_gap_nm; })},
      {.key = "support_material_bottom_contact_distance",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0",
       .doc = "From the part to a support that stands on it; 0: as at the top",
       .field = Bind([](auto& s) -> auto& { return s.planning.objects[0].support.bottom_gap_nm; })},
      {.key = "support_material_xy_spacing",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 20,
       .standard = "50%",
       .doc = "From supports to the part beside them",
       .relative_to = "external_perimeter_extrusion_width",
       .field = Bind([](auto& s) -> auto& { return s.planning.objects[0].support.xy_gap_nm; })},
      {.key = "support_material_closing_radius",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "2",
       .doc = "Gaps of columns (snug) up to twice this are closed",
       .field =
           Bind([](auto& s) -> auto& { return s.planning.objects[0].support.closing_radius_nm; })},
      {.key = "support_material_synchronize_layers",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Supports have the part's layers; else tops have heights of their own",
       .field =
           Bind([](auto& s) -> auto& { return s.planning.objects[0].support.synchronize_layers; })},
  };
}

std::vector<SettingSpec> Lines() {
  const auto pattern = [](SupportPattern value) { return static_cast<int>(value); };
  const auto interface = [](InterfacePattern value) { return static_cast<int>(value); };
  return {
      {.key = "support_material_interface_layers",
       .kind = Kind::kInteger,
       .unit = "layers",
       .min = 0,
       .max = 1000,
       .standard = "3",
       .doc = "Dense layers at a support's top",
       .field = Bind(
           [](auto& s) -> auto& { return s.planning.objects[0].support.top_interface_layers; })},
      {.key = "support_material_bottom_interface_layers",
       .kind = Kind::kInteger,
       .unit = "layers",
       .min = -1,
       .max = 1000,
       .standard = "-1",
       .doc = "Dense layers where a support stands on the part; -1: as many as at the top",
       .field = Bind(
           [](auto& s) -> auto& { return s.planning.objects[0].support.bottom_interface_layers; })},
      {.key = "support_material_interface_spacing",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "0",
       .doc = "Free room between the lines of those layers",
       .field = Bind(
           [](auto& s) -> auto& { return s.planning.objects[0].support.interface_spacing_nm; })},
      {.key = "support_material_interface_pattern",
       .kind = Kind::kChoice,
       .standard = "rectilinear",
       .doc = "Lines of those layers",
       .choices = {{"auto", interface(InterfacePattern::kRectilinear)},
                   {"rectilinear", interface(InterfacePattern::kRectilinear)},
                   {"concentric", interface(InterfacePattern::kConcentric)}},
       .field =
           Bind([](auto& s) -> auto& { return s.planning.objects[0].support.interface_pattern; })},
      {.key = "support_material_pattern",
       .kind = Kind::kChoice,
       .standard = "rectilinear",
       .doc = "Lines of a support's columns",
       .choices = {{"rectilinear", pattern(SupportPattern::kRectilinear)},
                   {"rectilinear-grid", pattern(SupportPattern::kRectilinearGrid)},
                   {"honeycomb", pattern(SupportPattern::kHoneycomb)}},
       .field = Bind([](auto& s) -> auto& { return s.planning.objects[0].support.pattern; })},
      {.key = "support_material_with_sheath",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "A line runs round a support's columns",
       .field = Bind([](auto& s) -> auto& { return s.planning.objects[0].support.sheath; })},
  };
}

std::vector<SettingSpec> Trees() {
  return {
      {.key = "support_tree_angle",
       .unit = "degrees",
       .min = 0,
       .max = 85,
       .standard = "40",
       .doc = "How far branches lean at most",
       .field = Bind<Scale::kDegrees>(
           [](auto& s) -> auto& { return s.planning.objects[0].support.tree.angle_rad; })},
      {.key = "support_tree_angle_slow",
       .unit = "degrees",
       .min = 0,
       .max = 85,
       .standard = "25",
       .doc = "How far they lean where nothing is in the way",
       .field = Bind<Scale::kDegrees>(
           [](auto& s) -> auto& { return s.planning.objects[0].support.tree.slow_angle_rad; })},
      {.key = "support_tree_branch_diameter",
       .unit = "mm",
       .min = 0.1,
       .max = 100,
       .standard = "2",
       .doc = "Thickness of a branch",
       .field = Bind(
           [](auto& s) -> auto& { return s.planning.objects[0].support.tree.branch_diameter_nm; })},
      {.key = "support_tree_branch_diameter_angle",
       .unit = "degrees",
       .min = 0,
       .max = 15,
       .standard = "5",
       .doc = "How fast branches become thicker downwards",
       .field = Bind<Scale::kDegrees>(
           [](auto& s) -> auto& { return s.planning.objects[0].support.tree.diameter_angle_rad; })},
      {.key = "support_tree_branch_diameter_double_wall",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "3",
       .doc = "Branches from this thickness on have two lines around them",
       .field = Bind([](auto& s) -> auto& {
         return s.planning.objects[0].support.tree.double_wall_diameter_nm;
       })},
      {.key = "support_tree_tip_diameter",
       .unit = "mm",
       .min = 0.1,
       .max = 100,
       .standard = "0.8",
       .doc = "Thickness of a branch where it carries the part",
       .field = Bind(
           [](auto& s) -> auto& { return s.planning.objects[0].support.tree.tip_diameter_nm; })},
      {.key = "support_tree_branch_distance",
       .unit = "mm",
       .min = 0.1,
       .max = 100,
       .standard = "1",
       .doc = "From tip to tip",
       .field = Bind(
           [](auto& s) -> auto& { return s.planning.objects[0].support.tree.branch_distance_nm; })},
      {.key = "support_tree_top_rate",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 5,
       .max = 100,
       .standard = "15%",
       .doc = "Share of what is carried that tips cover",
       .field = Bind<Scale::kPercent>(
           [](auto& s) -> auto& { return s.planning.objects[0].support.tree.top_rate; })},
  };
}

}  // namespace

std::vector<SettingSpec> SupportSettings() {
  std::vector<SettingSpec> settings = Where();
  for (const auto& section : {Lines, Trees})
    for (SettingSpec& spec : section()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
