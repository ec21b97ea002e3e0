#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

/// Returns a bead width: mm, a percentage of the layer height, or 0 for `extrusion_width`.
SettingSpec Width(std::string_view key, std::string_view doc, Field field) {
  return {.key = key,
          .kind = Kind::kNumberOrPercent,
          .unit = "mm",
          .min = 0,
          .max = 20,
          .standard = "0",
          .doc = doc,
          .relative_to = "layer_height",
          .field = field};
}

/// Returns a length: mm, or a percentage of the nozzle diameter.
SettingSpec OfNozzle(std::string_view key, std::string_view standard, std::string_view doc,
                     Field field) {
  return {.key = key,
          .kind = Kind::kNumberOrPercent,
          .unit = "mm",
          .min = 0,
          .max = 20,
          .standard = standard,
          .doc = doc,
          .relative_to = "nozzle_diameter",
          .field = field,
          .own_scope = Scope::kObject};
}

/// Returns the field of spiral_vase. Other settings determine the first hollow layer of the vase
/// (settle.h).
Field SpiralField() {
  return Convert<ObjectSlicingOptions>(
      [](ObjectSlicingOptions& row, const Value& value) {
        row.hollow_from = value.number != 0 ? 1 : 0;
      },
      [](const ObjectSlicingOptions& row) {
        return Value{.number = row.hollow_from > 0 ? 1.0 : 0.0};
      });
}

std::vector<SettingSpec> VariableWalls() {
  const auto generator = [](WallGenerator value) { return static_cast<int>(value); };
  return {
      {.key = "perimeter_generator",
       .kind = Kind::kChoice,
       .standard = "arachne",
       .doc = "Walls of variable width that fill thin places, or of constant width",
       .choices = {{"arachne", generator(WallGenerator::kArachne)},
                   {"classic", generator(WallGenerator::kClassic)}},
       .field = Bind<&RegionRow::walls, &BeadingOptions::generator>(),
       .own_scope = Scope::kObject,
       .orca = {{"wall_generator"}}},
      {.key = "thin_walls",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Prints places thinner than two walls as one line (classic; arachne always does)",
       .field = Bind<&RegionRow::walls, &BeadingOptions::thin_walls>(),
       .orca = {{"detect_thin_wall"}}},
      Orca({"wall_transition_length", OrcaValue::kPercent},
           OfNozzle("wall_transition_length", "100%",
                    "Over what length the number of walls changes by one",
                    Bind<&RegionRow::walls, &BeadingOptions::transition_length_nm>())),
      {.key = "wall_transition_angle",
       .unit = "degrees",
       .min = 1,
       .max = 59,
       .standard = "10",
       .doc = "Sides that meet at less than this get walls of variable width between them",
       .field = Bind<Scale::kDegrees, &RegionRow::walls, &BeadingOptions::transition_angle>(),
       .own_scope = Scope::kObject,
       .orca = {{"wall_transition_angle"}}},
      Orca({"wall_transition_filter_deviation", OrcaValue::kPercent},
           OfNozzle(
               "wall_transition_filter_deviation", "25%",
               "How far widths may go beyond their limits where that saves a change of the number",
               Bind<&RegionRow::walls, &BeadingOptions::transition_deviation_nm>())),
      {.key = "wall_distribution_count",
       .kind = Kind::kInteger,
       .min = 1,
       .max = 1000,
       .standard = "1",
       .doc = "Over how many walls from the middle outwards a change of width is spread",
       .field = Bind<&RegionRow::walls, &BeadingOptions::distribution_count>(),
       .own_scope = Scope::kObject,
       .orca = {{"wall_distribution_count"}}},
      Orca({"min_feature_size", OrcaValue::kPercent},
           OfNozzle("min_feature_size", "25%", "Thinner places are not printed (arachne)",
                    Bind<&RegionRow::walls, &BeadingOptions::min_feature_nm>())),
      Orca({"min_bead_width", OrcaValue::kPercent},
           OfNozzle("min_bead_width", "85%", "Least width of a wall of variable width",
                    Bind<&RegionRow::walls, &BeadingOptions::min_bead_width_nm>())),
      OfNozzle("max_bead_width", "200%",
               "Greatest width of a wall of variable width, or what the walls' own widths are",
               Bind<&RegionRow::walls, &BeadingOptions::max_bead_width_nm>()),
      {.key = "lock_outer_width",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Keeps the outer wall's width wherever a narrow wall fits between two of them",
       .field = Bind<&RegionRow::walls, &BeadingOptions::lock_outer_width>(),
       .own_scope = Scope::kObject},
  };
}

std::vector<SettingSpec> FuzzySkins() {
  return {
      {.key = "fuzzy_skin",
       .kind = Kind::kChoice,
       .standard = "none",
       .doc =
           "Which outermost walls get a rough skin: none, those of outer rings (external), those "
           "of holes as well (all); not on the first layer",
       .choices = {{"none", static_cast<int>(FuzzySkin::kNone)},
                   {"external", static_cast<int>(FuzzySkin::kContours)},
                   {"all", static_cast<int>(FuzzySkin::kAllWalls)}},
       .field = Bind<&RegionRow::walls, &BeadingOptions::fuzzy>(),
       .orca = {{"fuzzy_skin", OrcaValue::kChoice}}},
      {.key = "fuzzy_skin_thickness",
       .unit = "mm",
       .min = 0,
       .max = 10,
       .standard = "0.3",
       .doc = "How far points of a rough skin move, outwards and inwards, at most",
       .field = Bind<&RegionRow::walls, &BeadingOptions::fuzzy_thickness_nm>(),
       .orca = {{"fuzzy_skin_thickness"}}},
      {.key = "fuzzy_skin_point_dist",
       .unit = "mm",
       .min = 0.01,
       .max = 100,
       .standard = "0.8",
       .doc = "Mean distance of the points of a rough skin",
       .field = Bind<&RegionRow::walls, &BeadingOptions::fuzzy_point_distance_nm>(),
       .orca = {{"fuzzy_skin_point_distance"}}},
  };
}

std::vector<SettingSpec> Widths() {
  SettingSpec first =
      Orca({"initial_layer_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
           Width("first_layer_extrusion_width",
                 "Width of all beads of the first layer; 0: perimeter_extrusion_width",
                 Bind<&RegionRow::walls, &BeadingOptions::first_layer_width_nm>()));
  first.standard = "200%";
  first.relative_to = "first_layer_height";
  first.own_scope = Scope::kJob;
  first.also = Bind<&RegionRow::infill, &InfillOptions::first_layer_width_nm>();
  return {
      InScope(
          Scope::kObject,
          Orca({"line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
               Width("extrusion_width",
                     "Width of beads whose own setting is 0; 0: 1.125 times the nozzle's diameter "
                     "(top infill: the nozzle's diameter)",
                     {}))),
      first,
      Orca({"inner_wall_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
           Width("perimeter_extrusion_width", "Width of the inner walls; 0: extrusion_width",
                 Bind<&RegionRow::walls, &BeadingOptions::inner_width_nm>())),
      Orca({"outer_wall_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
           Width("external_perimeter_extrusion_width",
                 "Width of the outer walls; 0: extrusion_width",
                 Bind<&RegionRow::walls, &BeadingOptions::external_width_nm>())),
      Orca({"sparse_infill_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
           Width("infill_extrusion_width", "Width of the sparse infill's lines; 0: extrusion_width",
                 Bind<&RegionRow::infill, &InfillOptions::sparse_width_nm>())),
      Orca({"internal_solid_infill_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
           Width("solid_infill_extrusion_width",
                 "Width of the solid infill's lines; 0: extrusion_width",
                 Bind<&RegionRow::infill, &InfillOptions::solid_width_nm>())),
      Orca({"top_surface_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
           Width("top_infill_extrusion_width",
                 "Width of the top surface's lines; 0: extrusion_width",
                 Bind<&RegionRow::infill, &InfillOptions::top_width_nm>())),
  };
}

}  // namespace

std::vector<SettingSpec> WallSettings() {
  std::vector<SettingSpec> settings = {
      {.key = "perimeters",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 1000,
       .standard = "3",
       .doc = "Number of walls",
       .field = Bind<&RegionRow::walls, &BeadingOptions::perimeters>(),
       .orca = {{"wall_loops"}}},
      {.key = "only_one_perimeter_first_layer",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "One wall in the layer on the bed, and infill inside it",
       .field = Bind<&RegionRow::walls, &BeadingOptions::one_on_bed>(),
       .orca = {{"only_one_wall_first_layer"}}},
      {.key = "top_one_perimeter_type",
       .kind = Kind::kChoice,
       .standard = "none",
       .doc = "Where one wall is enough, with the top infill inside it: nowhere, on all surfaces "
              "that are seen from above, or in the object's last layer only",
       .choices = {{"none", static_cast<int>(OneWallOnTop::kNowhere)},
                   {"top", static_cast<int>(OneWallOnTop::kSurfaces)},
                   {"topmost", static_cast<int>(OneWallOnTop::kTopmost)}},
       .field = Bind<&RegionRow::walls, &BeadingOptions::one_on_top>(),
       .orca = {{"only_one_wall_top", OrcaValue::kChoice}}},
      {.key = "spiral_vase",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Above the solid bottom layers the outline of one object is one bead that winds up: "
              "no seam, no infill, no top; of each layer the largest contour counts. Several "
              "copies need complete_objects",
       .field = SpiralField(),
       .own_scope = Scope::kJob,
       .orca = {{"spiral_mode"}}},
      {.key = "extra_perimeters",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "More walls in slopes, until at least 70 % of the walls above rest on them; not "
              "where there is no infill (PrusaSlicer's own standard is 1, its printers' is 0)",
       .field = Bind<&RegionRow::walls, &BeadingOptions::extra_perimeters>()},
      {.key = "external_perimeters_first",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Prints the outermost wall before the inner ones",
       .field = Bind<&RegionRow::order, &WallOrder::external_perimeters_first>(),
       .orca = {{"wall_sequence", OrcaValue::kChoice}}},
      {.key = "inner_outer_inner",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Prints all inner walls but the outermost of them, then the outer wall, which they "
              "hold, and that one last; whatever external_perimeters_first says",
       .field = Bind<&RegionRow::order, &WallOrder::inner_outer_inner>(),
       .orca = {{"wall_sequence", OrcaValue::kChoice}}},
      {.key = "gap_fill_enabled",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Fills gaps between walls that are too narrow for another one",
       .field = Bind<&RegionRow::walls, &BeadingOptions::gap_fill>()},
      {.key = "gap_fill_min_width",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0.08",
       .doc = "Narrower gaps stay empty",
       .field = Bind<&RegionRow::walls, &BeadingOptions::min_gap_width_nm>()},
      {.key = "gap_fill_max_width",
       .unit = "mm",
       .min = 0,
       .max = 20,
       .standard = "0.8",
       .doc = "Wider gaps are the infill's",
       .field = Bind<&RegionRow::walls, &BeadingOptions::max_gap_width_nm>()},
      {.key = "prefer_clockwise_movements",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Prints loops round the outside clockwise, and those round holes the other way",
       .field = Bind<&MachineRow::order, &JobOrder::clockwise>(),
       .orca = {{"wall_direction", OrcaValue::kChoice}}},
      {.key = "ordering_improvement_moves",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 100e6,
       .standard = "200000",
       .doc = "How many changes of the printing order are tried per layer to shorten the travel",
       .field = Bind<&MachineRow::order, &JobOrder::improvement_moves>()},
  };
  for (SettingSpec& wall : VariableWalls()) settings.push_back(std::move(wall));
  for (SettingSpec& fuzzy : FuzzySkins()) settings.push_back(std::move(fuzzy));
  for (SettingSpec& width : Widths()) settings.push_back(std::move(width));
  return settings;
}

}  // namespace slicefarm::config::fdm
