#include "common/model/limits.h"
#include "processes/fdm/settings/table/needs.h"
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
       .doc = "Print supports below overhangs; 0: no supports",
       .field = Bind<&ObjectRow::support, &SupportOptions::on>(),
       .orca = {{"enable_support"}}},
      {.key = "support_material_auto",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Support all overhangs that support_material_threshold selects; 0: only overhangs "
              "inside support enforcers and in the layers of support_material_enforce_layers",
       .field = Bind<&ObjectRow::support, &SupportOptions::automatic>(),
       .orca = {{"support_type", OrcaValue::kChoice}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_style",
       .kind = Kind::kChoice,
       .standard = "grid",
       .doc = "Shape of supports. grid: columns that fill the cells of a coarse grid. snug: "
              "columns only below the overhang. organic: branches that join towards the bed. tree: "
              "another name of organic",
       .choices = {{"grid", style(SupportStyle::kGrid)},
                   {"snug", style(SupportStyle::kSnug)},
                   {"organic", style(SupportStyle::kTree)},
                   {"tree", style(SupportStyle::kTree)}},
       .field = Bind<&ObjectRow::support, &SupportOptions::style>(),
       .orca = {{"support_type", OrcaValue::kChoice}, {"support_style", OrcaValue::kChoice}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_threshold",
       .unit = "degrees",
       .min = 0,
       .max = 90,
       .standard = "0",
       .doc = "Slope of a surface, measured from horizontal, up to which the surface is supported; "
              "larger: more supports. 0: support_material_threshold_overlap decides",
       .field = Bind<Scale::kDegrees, &ObjectRow::support, &SupportOptions::threshold_rad>(),
       .orca = {{"support_threshold_angle"}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_threshold_overlap",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = -1,
       .max = 100,
       .standard = "-1",
       .doc = "Share of the outer wall's width on the layer below from which a wall needs no "
              "support, with support_material_threshold = 0. Larger: more supports. -1: 50%, or "
              "33% with support_material_style = organic",
       .field = Convert<ObjectRow>(
           [](ObjectRow& row, const Value& value) {
             row.support.threshold_overlap = value.number < 0 ? -1 : value.number / 100;
           },
           [](const ObjectRow& row) {
             const double share = row.support.threshold_overlap;
             return Value{.number = share < 0 ? -1 : Quantise(share * 100)};
           }),
       .orca = {{"support_threshold_overlap"}},
       .needs = {&needs::kNoThreshold, &needs::kSupports}},
      {.key = "support_material_critical_only",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Support only islands that start in the air, overhangs that reach more than 3 mm "
              "beyond the layer below, and overhangs inside support enforcers. 0: all overhangs "
              "that support_material_threshold selects",
       .field = Bind<&ObjectRow::support, &SupportOptions::critical_only>(),
       .needs = {&needs::kSupports}},
      {.key = "support_material_expansion",
       .unit = "mm",
       .min = -10,
       .max = 10,
       .standard = "0",
       .doc = "Distance by which supports with support_material_style = grid or snug extend beyond "
              "the overhang in x and y; negative: supports are smaller than the overhang",
       .field = Bind<&ObjectRow::support, &SupportOptions::expansion_nm>(),
       .orca = {{"support_expansion"}},
       .needs = {&needs::kColumnSupports}},
      {.key = "support_material_enforce_layers",
       .kind = Kind::kInteger,
       .unit = "layers",
       .min = 0,
       .max = kMostLayers,
       .standard = "0",
       .doc = "Number of layers, counted from the bed, in which all overhangs are supported, "
              "regardless of support_material_threshold; 0: no layers",
       .field = Bind<&ObjectRow::support, &SupportOptions::enforced_layers>(),
       .orca = {{"enforce_support_layers"}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_buildplate_only",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print only supports that stand on the bed; 0: supports may also stand on the part",
       .field = Bind<&ObjectRow::support, &SupportOptions::bed_only>(),
       .orca = {{"support_on_build_plate_only"}},
       .needs = {&needs::kSupports}},
      {.key = "dont_support_bridges",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Print no supports below bridges that rest on the part at both ends; 0: support "
              "bridges too",
       .field = Bind<&ObjectRow::support, &SupportOptions::skip_bridges>(),
       .orca = {{"bridge_no_support"}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_max_bridge_length",
       .unit = "mm",
       .min = 0,
       .max = 10'000,
       .standard = "0",
       .doc = "Length of the longest bridge that has no support with dont_support_bridges; longer "
              "bridges are supported. 0: no bridge is supported",
       .field = Bind<&ObjectRow::support, &SupportOptions::max_bridge_nm>(),
       .needs = {&needs::kSkippedBridges, &needs::kSupports}},
      {.key = "support_material_contact_distance",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0.2",
       .doc = "Vertical gap between the top of a support and the part; larger: the support comes "
              "off more easily, but the surface sags more",
       .field = Bind<&ObjectRow::support, &SupportOptions::top_gap_nm>(),
       .orca = {{"support_top_z_distance"}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_bottom_contact_distance",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0",
       .doc = "Vertical gap between the part and a support that stands on it; 0: "
              "support_material_contact_distance",
       .field = Bind<&ObjectRow::support, &SupportOptions::bottom_gap_nm>(),
       .orca = {{"support_bottom_z_distance"}},
       .needs = {&needs::kSupportsIfRequested}},
      {.key = "support_material_xy_spacing",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 20,
       .standard = "50%",
       .doc = "Horizontal gap between supports and the part",
       .relative_to = "external_perimeter_extrusion_width",
       .field = Bind<&ObjectRow::support, &SupportOptions::xy_gap_nm>(),
       .orca = {{"support_object_xy_distance"}},
       .needs = {&needs::kSupportsIfRequested}},
      {.key = "support_object_first_layer_gap",
       .unit = "mm",
       .min = -1,
       .max = 20,
       .standard = "-1",
       .doc = "Horizontal gap between supports and the part in the first layer; -1: "
              "support_material_xy_spacing. OrcaSlicer's default: 0.2",
       .field = Convert<ObjectRow>(
           [](ObjectRow& row, const Value& value) {
             row.support.first_xy_gap_nm = value.number < 0 ? -1 : FromMm(value.number);
           },
           [](const ObjectRow& row) {
             const Coord gap = row.support.first_xy_gap_nm;
             return Value{.number = gap < 0 ? -1 : Quantise(ToMm(gap))};
           }),
       .orca = {{"support_object_first_layer_gap"}},
       .needs = {&needs::kSupportsIfRequested}},
      {.key = "support_remove_small_overhang",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Do not support overhangs that are nowhere wider than two walls, unless they begin "
              "in the air or reach more than 3 mm. OrcaSlicer's default: 1",
       .field = Bind<&ObjectRow::support, &SupportOptions::ignore_small>(),
       .orca = {{"support_remove_small_overhang"}},
       .needs = {&needs::kSupportsIfRequested}},
      {.key = "support_material_closing_radius",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "2",
       .doc = "Half the width of the gaps that are closed between support columns with "
              "support_material_style = snug; larger: fewer, wider columns",
       .field = Bind<&ObjectRow::support, &SupportOptions::closing_radius_nm>(),
       .needs = {&needs::kSupports}},
      {.key = "support_material_synchronize_layers",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print supports with the layer heights of the part. 0: support layers may have other "
              "heights, so that support_material_contact_distance is exact",
       .field = Bind<&ObjectRow::support, &SupportOptions::synchronize_layers>(),
       .orca = {{"independent_support_layer_height", OrcaValue::kNot}},
       .needs = {&needs::kSupports}},
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
       .doc = "Number of dense interface layers at the top of a support; more layers: a smoother "
              "surface above. 0: none",
       .field = Bind<&ObjectRow::support, &SupportOptions::top_interface_layers>(),
       .orca = {{"support_interface_top_layers"}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_bottom_interface_layers",
       .kind = Kind::kInteger,
       .unit = "layers",
       .min = -1,
       .max = 1000,
       .standard = "-1",
       .doc = "Number of dense interface layers at the bottom of a support that stands on the "
              "part; 0: none. -1: support_material_interface_layers",
       .field = Bind<&ObjectRow::support, &SupportOptions::bottom_interface_layers>(),
       .orca = {{"support_interface_bottom_layers"}},
       .needs = {&needs::kSupportsIfRequested}},
      {.key = "support_material_interface_spacing",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "0",
       .doc = "Gap between lines of the dense interface layers at the top of a support or raft; 0: "
              "no gap, so that the interface is solid",
       .field = Bind<&ObjectRow::support, &SupportOptions::interface_spacing_nm>(),
       .orca = {{"support_interface_spacing"}},
       .needs = {&needs::kRaftOrSupports}},
      {.key = "support_material_bottom_interface_spacing",
       .unit = "mm",
       .min = -1,
       .max = 100,
       .standard = "-1",
       .doc = "Gap between lines of the dense interface layers at the bottom of a support; 0: no "
              "gap. -1: support_material_interface_spacing",
       .field = Convert<ObjectRow>(
           [](ObjectRow& row, const Value& value) {
             row.support.bottom_interface_spacing_nm = value.number < 0 ? -1 : FromMm(value.number);
           },
           [](const ObjectRow& row) {
             const Coord gap = row.support.bottom_interface_spacing_nm;
             return Value{.number = gap < 0 ? -1 : Quantise(ToMm(gap))};
           }),
       .orca = {{"support_bottom_interface_spacing"}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_interface_contact_loops",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print a second loop around the dense interface layers below the object. Unlike in "
              "other slicers, one loop is always printed, so that no line has a loose end",
       .field = Bind<&ObjectRow::support, &SupportOptions::contact_loops>(),
       .orca = {{"support_interface_loop_pattern"}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_interface_pattern",
       .kind = Kind::kChoice,
       .standard = "rectilinear",
       .doc = "Pattern of the dense interface layers of supports. rectilinear: parallel lines. "
              "concentric: loops along the edge. auto: rectilinear",
       .choices = {{"auto", interface(InterfacePattern::kRectilinear)},
                   {"rectilinear", interface(InterfacePattern::kRectilinear)},
                   {"concentric", interface(InterfacePattern::kConcentric)}},
       .field = Bind<&ObjectRow::support, &SupportOptions::interface_pattern>(),
       .orca = {{"support_interface_pattern", OrcaValue::kChoice}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_pattern",
       .kind = Kind::kChoice,
       .standard = "rectilinear",
       .doc = "Pattern of support columns. rectilinear: parallel lines. rectilinear-grid: crossing "
              "lines. honeycomb: hexagons",
       .choices = {{"rectilinear", pattern(SupportPattern::kRectilinear)},
                   {"rectilinear-grid", pattern(SupportPattern::kRectilinearGrid)},
                   {"honeycomb", pattern(SupportPattern::kHoneycomb)}},
       .field = Bind<&ObjectRow::support, &SupportOptions::pattern>(),
       .orca = {{"support_base_pattern", OrcaValue::kChoice}},
       .needs = {&needs::kSupports}},
      {.key = "support_material_with_sheath",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Print a line around support columns, which makes them stronger; 0: only "
              "support_material_pattern",
       .field = Bind<&ObjectRow::support, &SupportOptions::sheath>(),
       .needs = {&needs::kSupports}},
  };
}

std::vector<SettingSpec> Trees() {
  return {
      {.key = "support_tree_angle",
       .unit = "degrees",
       .min = 0,
       .max = 85,
       .standard = "40",
       .doc = "Largest angle of branches, measured from vertical; larger: flatter branches",
       .field = Bind<Scale::kDegrees, &ObjectRow::support, &SupportOptions::tree,
                     &TreeOptions::angle_rad>(),
       .orca = {{"tree_support_branch_angle"}},
       .needs = {&needs::kTreeSupports}},
      {.key = "support_tree_angle_slow",
       .unit = "degrees",
       .min = 0,
       .max = 85,
       .standard = "25",
       .doc =
           "Angle of branches, measured from vertical, where no obstacle requires a larger angle",
       .field = Bind<Scale::kDegrees, &ObjectRow::support, &SupportOptions::tree,
                     &TreeOptions::slow_angle_rad>(),
       .orca = {{"tree_support_angle_slow"}},
       .needs = {&needs::kTreeSupports}},
      {.key = "support_tree_branch_diameter",
       .unit = "mm",
       .min = 0.1,
       .max = 100,
       .standard = "2",
       .doc = "Diameter that a branch reaches below its thin tip; farther down the branch widens "
              "by support_tree_branch_diameter_angle",
       .field =
           Bind<&ObjectRow::support, &SupportOptions::tree, &TreeOptions::branch_diameter_nm>(),
       .orca = {{"tree_support_branch_diameter"}},
       .needs = {&needs::kTreeSupports}},
      {.key = "support_tree_branch_diameter_angle",
       .unit = "degrees",
       .min = 0,
       .max = 15,
       .standard = "5",
       .doc = "Angle at which branches widen downwards; 0: the same diameter everywhere",
       .field = Bind<Scale::kDegrees, &ObjectRow::support, &SupportOptions::tree,
                     &TreeOptions::diameter_angle_rad>(),
       .orca = {{"tree_support_branch_diameter_angle"}},
       .needs = {&needs::kTreeSupports}},
      {.key = "support_tree_branch_diameter_double_wall",
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "3",
       .doc = "Diameter from which branches have two walls; thinner branches have one wall",
       .field = Bind<&ObjectRow::support, &SupportOptions::tree,
                     &TreeOptions::double_wall_diameter_nm>(),
       .needs = {&needs::kTreeSupports}},
      {.key = "support_tree_tip_diameter",
       .unit = "mm",
       .min = 0.1,
       .max = 100,
       .standard = "0.8",
       .doc = "Diameter of a branch at its tip, where it supports the part",
       .field = Bind<&ObjectRow::support, &SupportOptions::tree, &TreeOptions::tip_diameter_nm>(),
       .orca = {{"tree_support_tip_diameter"}},
       .needs = {&needs::kTreeSupports}},
      {.key = "support_tree_branch_distance",
       .unit = "mm",
       .min = 0.1,
       .max = 100,
       .standard = "1",
       .doc = "Distance between neighbouring branch tips; smaller: more tips below an overhang",
       .field =
           Bind<&ObjectRow::support, &SupportOptions::tree, &TreeOptions::branch_distance_nm>(),
       .orca = {{"tree_support_branch_distance"}},
       .needs = {&needs::kTreeSupports}},
      {.key = "support_tree_top_rate",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 5,
       .max = 100,
       .standard = "15%",
       .doc = "Share of the overhang's area that branch tips touch; larger: more tips. 15% and "
              "less: tips at support_tree_branch_distance",
       .field = Bind<Scale::kPercent, &ObjectRow::support, &SupportOptions::tree,
                     &TreeOptions::top_rate>(),
       .orca = {{"tree_support_top_rate", OrcaValue::kPercent}},
       .needs = {&needs::kTreeSupports}},
  };
}

}  // namespace

std::vector<SettingSpec> SupportSettings() {
  std::vector<SettingSpec> settings = Where();
  for (const auto& section : {Lines, SupportIroningSettings, Trees})
    for (SettingSpec& spec : section()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
