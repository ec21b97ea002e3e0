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

SettingSpec SpiralFlow(std::string_view key, std::string_view doc, Field field, OrcaName orca) {
  return {.key = key,
          .min = 0,
          .max = 1,
          .standard = "0",
          .doc = doc,
          .field = field,
          .orca = {orca},
          .needs = {&needs::kSpiral}};
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
       .doc = "Method that lays out walls. arachne: walls of variable width, which fill thin "
              "features. classic: walls of constant width",
       .choices = {{"arachne", generator(WallGenerator::kArachne)},
                   {"classic", generator(WallGenerator::kClassic)}},
       .field = Bind<&RegionRow::walls, &BeadingOptions::generator>(),
       .own_scope = Scope::kObject,
       .orca = {{"wall_generator"}}},
      {.key = "thin_walls",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Print features thinner than two walls as a single line, with perimeter_generator = "
              "classic; arachne always does this. 0: such features get a loop that overlaps "
              "itself, if a wall fits",
       .field = Bind<&RegionRow::walls, &BeadingOptions::thin_walls>(),
       .orca = {{"detect_thin_wall"}}},
      Orca({"wall_transition_length", OrcaValue::kPercent},
           OfNozzle("wall_transition_length", "100%",
                    "Length along a feature over which the number of walls changes by one; "
                    "smaller: a more sudden change",
                    Bind<&RegionRow::walls, &BeadingOptions::transition_length_nm>())),
      {.key = "wall_transition_angle",
       .unit = "degrees",
       .min = 1,
       .max = 59,
       .standard = "10",
       .doc = "Angle of a wedge of the part below which walls of variable width fill the wedge, "
              "with perimeter_generator = arachne; smaller: only sharper wedges",
       .field = Bind<Scale::kDegrees, &RegionRow::walls, &BeadingOptions::transition_angle>(),
       .own_scope = Scope::kObject,
       .orca = {{"wall_transition_angle"}}},
      Orca({"wall_transition_filter_deviation", OrcaValue::kPercent},
           OfNozzle("wall_transition_filter_deviation", "25%",
                    "Distance by which extrusion widths may be below min_bead_width or above "
                    "max_bead_width so that the number of walls changes less often",
                    Bind<&RegionRow::walls, &BeadingOptions::transition_deviation_nm>())),
      {.key = "wall_distribution_count",
       .kind = Kind::kInteger,
       .min = 1,
       .max = 1000,
       .standard = "1",
       .doc = "Number of walls, counted from the middle of a feature, that become wider or "
              "narrower to fill its thickness, with perimeter_generator = arachne",
       .field = Bind<&RegionRow::walls, &BeadingOptions::distribution_count>(),
       .own_scope = Scope::kObject,
       .orca = {{"wall_distribution_count"}}},
      Orca({"min_feature_size", OrcaValue::kPercent},
           OfNozzle("min_feature_size", "25%",
                    "Thickness below which features of the part are not printed, with "
                    "perimeter_generator = arachne",
                    Bind<&RegionRow::walls, &BeadingOptions::min_feature_nm>())),
      Orca({"min_bead_width", OrcaValue::kPercent},
           OfNozzle("min_bead_width", "85%",
                    "Smallest extrusion width of walls with perimeter_generator = arachne; thinner "
                    "features are printed with this width",
                    Bind<&RegionRow::walls, &BeadingOptions::min_bead_width_nm>())),
      Orca({"initial_layer_min_bead_width", OrcaValue::kPercent},
           Needing({&needs::kArachne},
                   OfNozzle("first_layer_min_bead_width", "0",
                            "Smallest extrusion width of walls in the first layer with "
                            "perimeter_generator = arachne; 0: min_bead_width",
                            Bind<&RegionRow::walls, &BeadingOptions::first_layer_min_bead_nm>()))),
      OfNozzle("max_bead_width", "200%",
               "Largest extrusion width of walls with perimeter_generator = arachne; at least the "
               "width settings of the walls",
               Bind<&RegionRow::walls, &BeadingOptions::max_bead_width_nm>()),
      {.key = "min_length_factor",
       .min = 0,
       .max = 100,
       .standard = "0",
       .doc = "Length of the shortest open line between walls of variable width, in widths of the "
              "outer wall. Shorter lines are left out, except in the lowest and the highest layer "
              "of the object. 0: all lines are printed. OrcaSlicer's default: 0.5",
       .field = Bind<&RegionRow::walls, &BeadingOptions::min_length_factor>(),
       .orca = {{"min_length_factor"}},
       .needs = {&needs::kArachne}},
      {.key = "wall_maximum_resolution",
       .unit = "mm",
       .min = 0.001,
       .max = 10,
       .standard = "0.5",
       .doc = "Edges of walls of variable width that are shorter than this may be merged, within "
              "wall_maximum_deviation",
       .field = Bind<&RegionRow::walls, &BeadingOptions::least_edge_nm>(),
       .orca = {{"wall_maximum_resolution"}},
       .needs = {&needs::kArachne}},
      {.key = "wall_maximum_deviation",
       .unit = "mm",
       .min = 0.005,
       .max = 1,
       .standard = "0.005",
       .doc = "Largest distance by which walls of variable width may move where short edges are "
              "merged (wall_maximum_resolution); larger: coarser walls, mostly with fewer moves. "
              "OrcaSlicer's default: 0.025",
       .field = Bind<&RegionRow::walls, &BeadingOptions::edge_deviation_nm>(),
       .orca = {{"wall_maximum_deviation"}},
       .needs = {&needs::kArachne}},
      {.key = "lock_outer_width",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Keep the extrusion width of the two outer walls where a third, narrow wall fits "
              "between them; 0: both may become wider instead, up to max_bead_width",
       .field = Bind<&RegionRow::walls, &BeadingOptions::lock_outer_width>(),
       .own_scope = Scope::kObject},
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
      InScope(
          Scope::kObject,
          Orca({"line_width", OrcaValue::kPercentOf, "nozzle_diameter"},
               Width("extrusion_width",
                     "Extrusion width of lines that have 0 in their own width setting; 0: 1.125 "
                     "times the nozzle diameter, and the nozzle diameter for top surfaces",
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

std::vector<SettingSpec> Loops() {
  return {
      {.key = "perimeters",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 1000,
       .standard = "3",
       .doc = "Number of walls around each layer; 0: no walls",
       .field = Bind<&RegionRow::walls, &BeadingOptions::perimeters>(),
       .orca = {{"wall_loops"}}},
      {.key = "only_one_perimeter_first_layer",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print a single wall in the first layer, with infill inside it; 0: the number of "
              "walls in `perimeters`",
       .field = Bind<&RegionRow::walls, &BeadingOptions::one_on_bed>(),
       .orca = {{"only_one_wall_first_layer"}}},
      {.key = "top_one_perimeter_type",
       .kind = Kind::kChoice,
       .standard = "none",
       .doc = "Surfaces that have a single wall, with top infill inside it. none: no surface. top: "
              "all top surfaces. topmost: only the last layer of the object",
       .choices = {{"none", static_cast<int>(OneWallOnTop::kNowhere)},
                   {"top", static_cast<int>(OneWallOnTop::kSurfaces)},
                   {"topmost", static_cast<int>(OneWallOnTop::kTopmost)}},
       .field = Bind<&RegionRow::walls, &BeadingOptions::one_on_top>(),
       .orca = {{"only_one_wall_top", OrcaValue::kChoice}}},
      {.key = "min_width_top_surface",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 100,
       .standard = "0",
       .doc = "Width up to which a top surface keeps its inner walls although "
              "top_one_perimeter_type = top; 0: half the width of an inner wall",
       .relative_to = "perimeter_extrusion_width",
       .field = Bind<&RegionRow::walls, &BeadingOptions::min_top_width_nm>(),
       .orca = {{"min_width_top_surface"}},
       .needs = {&needs::kOneWallOnTop}},
      {.key = "precise_outer_wall",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Place the wall beside an outer wall at the distance of their full widths, without "
              "overlap, so that the outer wall keeps its exact position. Only where infill is "
              "inside the walls",
       .field = Bind<&RegionRow::walls, &BeadingOptions::precise_outer>(),
       .orca = {{"precise_outer_wall"}},
       .needs = {&needs::kInnerWallsFirst}},
      {.key = "overhang_reverse",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Change the printing direction of overhanging walls in every second layer, which "
              "improves steep overhangs; 0: the same direction in all layers",
       .field = Bind<&RegionRow::motion, &RegionMotion::reversal, &OverhangReversal::on>(),
       .orca = {{"overhang_reverse"}}},
      {.key = "overhang_reverse_internal_only",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc =
           "Change the direction by overhang_reverse for inner walls only; 0: for outer walls too",
       .field = Bind<&RegionRow::motion, &RegionMotion::reversal, &OverhangReversal::inner_only>(),
       .orca = {{"overhang_reverse_internal_only"}},
       .needs = {&needs::kOverhangReverse}},
      {.key = "overhang_reverse_threshold",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 20,
       .standard = "50%",
       .doc = "Distance by which the edge of a wall must extend beyond the layer below so that "
              "overhang_reverse changes its direction. 0, or overhangs = 0: all walls change",
       .relative_to = "perimeter_extrusion_width",
       .field =
           Bind<&RegionRow::motion, &RegionMotion::reversal, &OverhangReversal::threshold_mm>(),
       .orca = {{"overhang_reverse_threshold"}},
       .needs = {&needs::kOverhangReverse}},
  };
}

std::vector<SettingSpec> SpiralVase() {
  return {
      {.key = "spiral_vase",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print one object as a single wall that rises continuously above the solid bottom "
              "layers, without seam, infill and top. Only the largest contour of each layer is "
              "printed. Several copies need complete_objects",
       .field = SpiralField(),
       .own_scope = Scope::kJob,
       .orca = {{"spiral_mode"}}},
      {.key = "spiral_vase_smooth",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Move each turn of spiral_vase gradually from the contour of the turn below to its "
              "own contour; 0: each turn keeps its contour, so that slopes show a seam",
       .own_scope = Scope::kJob,
       .orca = {{"spiral_mode_smooth"}}},
      SpiralFlow("spiral_vase_starting_flow_ratio",
                 "Flow at the start of the first turn of spiral_vase; it rises to 1 in this turn",
                 Bind<&MachineRow::motion, &MachineMotion::spiral, &SpiralMotion::start_flow>(),
                 {"spiral_starting_flow_ratio"}),
      SpiralFlow("spiral_vase_finishing_flow_ratio",
                 "Flow at the end of the last turn of spiral_vase; it falls from 1 in this turn",
                 Bind<&MachineRow::motion, &MachineMotion::spiral, &SpiralMotion::end_flow>(),
                 {"spiral_finishing_flow_ratio"}),
      {.key = "spiral_vase_max_xy_smoothing",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "Largest distance between a point and the turn below at which spiral_vase_smooth "
              "moves the point towards this turn; 0: four times the width of the wall",
       .relative_to = "nozzle_diameter",
       .field = Bind<&MachineRow::motion, &MachineMotion::spiral, &SpiralMotion::reach_nm>(),
       .orca = {{"spiral_mode_max_xy_smoothing"}},
       .needs = {&needs::kSpiral}},
  };
}

std::vector<SettingSpec> OrderAndGaps() {
  return {
      {.key = "extra_perimeters",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc =
           "Add walls in slopes until at least 70 % of the walls of the layer above are supported; "
           "only where there is infill. Default in PrusaSlicer: 1; in its printer profiles: 0",
       .field = Bind<&RegionRow::walls, &BeadingOptions::extra_perimeters>()},
      {.key = "external_perimeters_first",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print outer walls before inner walls; 0: inner walls first, which makes overhangs "
              "better",
       .field = Bind<&RegionRow::order, &WallOrder::external_perimeters_first>(),
       .orca = {{"wall_sequence", OrcaValue::kChoice}}},
      {.key = "inner_outer_inner",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print inner walls except the one next to the outer wall, then the outer wall, then "
              "that inner wall; overrides external_perimeters_first",
       .field = Bind<&RegionRow::order, &WallOrder::inner_outer_inner>(),
       .orca = {{"wall_sequence", OrcaValue::kChoice}}},
      {.key = "unsupported_wall_last",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print closed walls over air that lie beside no wall on the layer below after the "
              "infill, which then holds them; 0: with the other walls",
       .field = Bind<&RegionRow::order, &WallOrder::unsupported_last>(),
       .orca = {{"unsupported_wall_last"}}},
      {.key = "alternate_extra_wall",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print one more wall in every second layer, so that the infill is held between walls "
              "from above and from below",
       .field = Bind<&RegionRow::walls, &BeadingOptions::alternate_extra>(),
       .orca = {{"alternate_extra_wall"}}},
      {.key = "gap_fill_enabled",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Fill gaps between walls that are too narrow for another wall",
       .field = Bind<&RegionRow::walls, &BeadingOptions::gap_fill>()},
      {.key = "gap_fill_target",
       .kind = Kind::kChoice,
       .standard = "everywhere",
       .doc = "Places where infill areas narrower than gap_fill_max_width are filled with gap fill "
              "instead of infill. everywhere: all such areas. topbottom: areas with nothing above "
              "or below them. nowhere: none",
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
       .doc = "Length of the shortest line of gap fill; shorter gaps remain empty. 0: gaps of any "
              "length are filled",
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
       .doc = "Print walls of outer contours clockwise and walls of holes counter-clockwise, seen "
              "from above; 0: the opposite",
       .field = Bind<&MachineRow::order, &JobOrder::clockwise>(),
       .also = Bind<&MachineRow::motion, &MachineMotion::clockwise>(),
       .orca = {{"wall_direction", OrcaValue::kChoice}}},
      {.key = "ordering_improvement_moves",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 100e6,
       .standard = "200000",
       .doc = "Number of changes to the printing order that are tried in each layer to shorten "
              "travels. Larger: shorter travels, but more computing time. 0: none",
       .field = Bind<&MachineRow::order, &JobOrder::improvement_moves>()},
  };
}

}  // namespace

std::vector<SettingSpec> WallSettings() {
  std::vector<SettingSpec> settings;
  for (const auto& section :
       {Loops, SpiralVase, OrderAndGaps, VariableWalls, FuzzySkinSettings, Widths})
    for (SettingSpec& spec : section()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
