#include "processes/fdm/settings/table/needs.h"
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
/// (derive_options.h).
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
       .doc = "Generator of walls. arachne: variable width, which fills thin features. classic: "
              "constant width",
       .choices = {{"arachne", generator(WallGenerator::kArachne)},
                   {"classic", generator(WallGenerator::kClassic)}},
       .field = Bind<&RegionRow::walls, &BeadingOptions::generator>(),
       .own_scope = Scope::kObject,
       .orca = {{"wall_generator"}}},
      {.key = "thin_walls",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Print features thinner than two walls as a single line. Only for wall_generator = "
              "classic; arachne always does this",
       .field = Bind<&RegionRow::walls, &BeadingOptions::thin_walls>(),
       .orca = {{"detect_thin_wall"}}},
      Orca({"wall_transition_length", OrcaValue::kPercent},
           OfNozzle("wall_transition_length", "100%",
                    "Length over which the number of walls changes by one",
                    Bind<&RegionRow::walls, &BeadingOptions::transition_length_nm>())),
      {.key = "wall_transition_angle",
       .unit = "degrees",
       .min = 1,
       .max = 59,
       .standard = "10",
       .doc = "Angle between opposite sides below which walls of variable width fill the wedge "
              "between them",
       .field = Bind<Scale::kDegrees, &RegionRow::walls, &BeadingOptions::transition_angle>(),
       .own_scope = Scope::kObject,
       .orca = {{"wall_transition_angle"}}},
      Orca({"wall_transition_filter_deviation", OrcaValue::kPercent},
           OfNozzle("wall_transition_filter_deviation", "25%",
                    "Amount by which widths may exceed their limits to avoid changing the number "
                    "of walls",
                    Bind<&RegionRow::walls, &BeadingOptions::transition_deviation_nm>())),
      {.key = "wall_distribution_count",
       .kind = Kind::kInteger,
       .min = 1,
       .max = 1000,
       .standard = "1",
       .doc = "Number of walls, counted from the middle, over which a change of width is spread",
       .field = Bind<&RegionRow::walls, &BeadingOptions::distribution_count>(),
       .own_scope = Scope::kObject,
       .orca = {{"wall_distribution_count"}}},
      Orca({"min_feature_size", OrcaValue::kPercent},
           OfNozzle("min_feature_size", "25%",
                    "Thickness below which parts of the shape are not printed (arachne)",
                    Bind<&RegionRow::walls, &BeadingOptions::min_feature_nm>())),
      Orca({"min_bead_width", OrcaValue::kPercent},
           OfNozzle("min_bead_width", "85%", "Smallest extrusion width of walls of variable width",
                    Bind<&RegionRow::walls, &BeadingOptions::min_bead_width_nm>())),
      Orca({"initial_layer_min_bead_width", OrcaValue::kPercent},
           Needing({&needs::kArachne},
                   OfNozzle(
                       "first_layer_min_bead_width", "0",
                       "Smallest extrusion width of walls of variable width in the first layer; 0: "
                       "min_bead_width",
                       Bind<&RegionRow::walls, &BeadingOptions::first_layer_min_bead_nm>()))),
      OfNozzle("max_bead_width", "200%",
               "Largest extrusion width of walls of variable width; never less than the width "
               "settings of the walls",
               Bind<&RegionRow::walls, &BeadingOptions::max_bead_width_nm>()),
      {.key = "lock_outer_width",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Keep the extrusion width of the outer walls where a third, narrow wall fits between "
              "them",
       .field = Bind<&RegionRow::walls, &BeadingOptions::lock_outer_width>(),
       .own_scope = Scope::kObject},
  };
}

std::vector<SettingSpec> FuzzySkins() {
  return {
      {.key = "fuzzy_skin",
       .kind = Kind::kChoice,
       .standard = "none",
       .doc = "Outermost walls that get a rough surface (not in the first layer). external: outer "
              "contours. all: walls of holes too",
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
       .doc = "Largest distance by which points of a fuzzy skin move outwards or inwards",
       .field = Bind<&RegionRow::walls, &BeadingOptions::fuzzy_thickness_nm>(),
       .orca = {{"fuzzy_skin_thickness"}},
       .needs = {&needs::kFuzzySkin}},
      {.key = "fuzzy_skin_point_dist",
       .unit = "mm",
       .min = 0.01,
       .max = 100,
       .standard = "0.8",
       .doc = "Mean distance between the points of a fuzzy skin; smaller: finer",
       .field = Bind<&RegionRow::walls, &BeadingOptions::fuzzy_point_distance_nm>(),
       .orca = {{"fuzzy_skin_point_distance"}},
       .needs = {&needs::kFuzzySkin}},
  };
}

std::vector<SettingSpec> Widths() {
  SettingSpec first = Orca({"initial_layer_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
                           Width("first_layer_extrusion_width",
                                 "Extrusion width of the first layer; 0: perimeter_extrusion_width",
                                 Bind<&RegionRow::walls, &BeadingOptions::first_layer_width_nm>()));
  first.standard = "200%";
  first.relative_to = "first_layer_height";
  first.own_scope = Scope::kJob;
  first.also = Bind<&RegionRow::infill, &InfillOptions::first_layer_width_nm>();
  return {
      InScope(Scope::kObject,
              Orca({"line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
                   Width("extrusion_width",
                         "Extrusion width of lines for which the width setting is 0; 0: 1.125 "
                         "times the nozzle diameter (top surfaces: the nozzle diameter)",
                         {}))),
      first,
      Orca({"inner_wall_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
           Width("perimeter_extrusion_width", "Extrusion width of inner walls; 0: extrusion_width",
                 Bind<&RegionRow::walls, &BeadingOptions::inner_width_nm>())),
      Orca({"outer_wall_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
           Width("external_perimeter_extrusion_width",
                 "Extrusion width of outer walls; 0: extrusion_width",
                 Bind<&RegionRow::walls, &BeadingOptions::external_width_nm>())),
      Orca({"sparse_infill_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
           Width("infill_extrusion_width", "Extrusion width of sparse infill; 0: extrusion_width",
                 Bind<&RegionRow::infill, &InfillOptions::sparse_width_nm>())),
      Orca({"internal_solid_infill_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
           Width("solid_infill_extrusion_width",
                 "Extrusion width of solid infill; 0: extrusion_width",
                 Bind<&RegionRow::infill, &InfillOptions::solid_width_nm>())),
      Orca(
          {"top_surface_line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
          Width("top_infill_extrusion_width", "Extrusion width of top surfaces; 0: extrusion_width",
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
       .doc = "Print a single wall in the first layer, with infill inside it",
       .field = Bind<&RegionRow::walls, &BeadingOptions::one_on_bed>(),
       .orca = {{"only_one_wall_first_layer"}}},
      {.key = "top_one_perimeter_type",
       .kind = Kind::kChoice,
       .standard = "none",
       .doc = "Surfaces with a single wall and top infill inside it. none: no surface. top: all "
              "top surfaces. topmost: the last layer of the object",
       .choices = {{"none", static_cast<int>(OneWallOnTop::kNowhere)},
                   {"top", static_cast<int>(OneWallOnTop::kSurfaces)},
                   {"topmost", static_cast<int>(OneWallOnTop::kTopmost)}},
       .field = Bind<&RegionRow::walls, &BeadingOptions::one_on_top>(),
       .orca = {{"only_one_wall_top", OrcaValue::kChoice}}},
      {.key = "min_width_top_surface",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 15,
       .standard = "0",
       .doc = "Width below which a top surface keeps its inner walls in spite of "
              "top_one_perimeter_type = top; 0: half an inner wall",
       .relative_to = "perimeter_extrusion_width",
       .field = Bind<&RegionRow::walls, &BeadingOptions::min_top_width_nm>(),
       .orca = {{"min_width_top_surface"}},
       .needs = {&needs::kOneWallOnTop}},
      {.key = "precise_outer_wall",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Keep the wall beside an outer wall at the distance of their full widths, so that it "
              "does not press the outer wall outwards; only where infill is inside the walls",
       .field = Bind<&RegionRow::walls, &BeadingOptions::precise_outer>(),
       .orca = {{"precise_outer_wall"}},
       .needs = {&needs::kInnerWallsFirst}},
      {.key = "overhang_reverse",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print walls that overhang in the other direction in every second layer, which "
              "improves steep overhangs",
       .field = Bind<&RegionRow::motion, &RegionMotion::reversal, &OverhangReversal::on>(),
       .orca = {{"overhang_reverse"}}},
      {.key = "overhang_reverse_internal_only",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Apply overhang_reverse to inner walls only",
       .field = Bind<&RegionRow::motion, &RegionMotion::reversal, &OverhangReversal::inner_only>(),
       .orca = {{"overhang_reverse_internal_only"}},
       .needs = {&needs::kOverhangReverse}},
      {.key = "overhang_reverse_threshold",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 20,
       .standard = "50%",
       .doc =
           "Overhang of a wall's edge beyond the layer below from which overhang_reverse applies "
           "to the wall; 0, or overhangs = 0: to all walls",
       .relative_to = "perimeter_extrusion_width",
       .field =
           Bind<&RegionRow::motion, &RegionMotion::reversal, &OverhangReversal::threshold_mm>(),
       .orca = {{"overhang_reverse_threshold"}},
       .needs = {&needs::kOverhangReverse}},
      {.key = "spiral_vase",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print one object as a single wall that rises continuously above the solid bottom "
              "layers: no seam, infill or top, and only the largest contour of each layer. Several "
              "copies need complete_objects",
       .field = SpiralField(),
       .own_scope = Scope::kJob,
       .orca = {{"spiral_mode"}}},
      {.key = "spiral_vase_smooth",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Move each turn of spiral_vase gradually from the contour below to its own; 0: turns "
              "keep their contour, so that slopes show a seam",
       .own_scope = Scope::kJob,
       .orca = {{"spiral_mode_smooth"}}},
      {.key = "extra_perimeters",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Add walls in slopes until at least 70 % of the walls above are supported; only "
              "where there is infill. Default in PrusaSlicer: 1; in its printer profiles: 0",
       .field = Bind<&RegionRow::walls, &BeadingOptions::extra_perimeters>()},
      {.key = "external_perimeters_first",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print outer walls before inner walls",
       .field = Bind<&RegionRow::order, &WallOrder::external_perimeters_first>(),
       .orca = {{"wall_sequence", OrcaValue::kChoice}}},
      {.key = "inner_outer_inner",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print the inner walls except the one next to the outer wall, then the outer wall, "
              "then that last inner wall; overrides external_perimeters_first",
       .field = Bind<&RegionRow::order, &WallOrder::inner_outer_inner>(),
       .orca = {{"wall_sequence", OrcaValue::kChoice}}},
      {.key = "gap_fill_enabled",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Fill gaps between walls that are too narrow for another wall",
       .field = Bind<&RegionRow::walls, &BeadingOptions::gap_fill>()},
      {.key = "gap_fill_target",
       .kind = Kind::kChoice,
       .standard = "everywhere",
       .doc = "Parts of the infill's area that are filled like gaps because they are narrower than "
              "gap_fill_max_width. topbottom: parts with nothing above or below them. nowhere: all "
              "parts are left to the lines of the infill",
       .choices = {{"everywhere", static_cast<int>(GapFillTarget::kEverywhere)},
                   {"topbottom", static_cast<int>(GapFillTarget::kTopBottom)},
                   {"nowhere", static_cast<int>(GapFillTarget::kNowhere)}},
       .field = Bind<&RegionRow::walls, &BeadingOptions::gap_target>(),
       .orca = {{"gap_fill_target"}},
       .needs = {&needs::kGapFill}},
      {.key = "gap_fill_min_length",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "Length of the shortest line of gap fill; shorter gaps remain empty",
       .field = Bind<&RegionRow::walls, &BeadingOptions::min_gap_length_nm>(),
       .orca = {{"filter_out_gap_fill"}}},
      {.key = "gap_fill_min_width",
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0.08",
       .doc = "Narrowest gap that gap fill fills; narrower gaps remain empty",
       .field = Bind<&RegionRow::walls, &BeadingOptions::min_gap_width_nm>()},
      {.key = "gap_fill_max_width",
       .unit = "mm",
       .min = 0,
       .max = 20,
       .standard = "0.8",
       .doc = "Widest gap that gap fill fills; infill fills wider gaps",
       .field = Bind<&RegionRow::walls, &BeadingOptions::max_gap_width_nm>()},
      {.key = "prefer_clockwise_movements",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print loops of outer contours clockwise and loops of holes counter-clockwise; 0: "
              "the opposite",
       .field = Bind<&MachineRow::order, &JobOrder::clockwise>(),
       .also = Bind<&MachineRow::motion, &MachineMotion::clockwise>(),
       .orca = {{"wall_direction", OrcaValue::kChoice}}},
      {.key = "ordering_improvement_moves",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 100e6,
       .standard = "200000",
       .doc = "Number of changes to the printing order that are tried in each layer to shorten "
              "travels; larger: shorter travels, more computing time",
       .field = Bind<&MachineRow::order, &JobOrder::improvement_moves>()},
  };
  for (SettingSpec& wall : VariableWalls()) settings.push_back(std::move(wall));
  for (SettingSpec& fuzzy : FuzzySkins()) settings.push_back(std::move(fuzzy));
  for (SettingSpec& width : Widths()) settings.push_back(std::move(width));
  return settings;
}

}  // namespace slicefarm::config::fdm
