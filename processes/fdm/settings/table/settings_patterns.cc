#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

template <FillPattern... kPatterns>
bool HasPattern(const JobRows& s) {
  const InfillOptions& infill = FdmOf(s).region.infill;
  return !infill.choose_pattern && ((infill.pattern == kPatterns) || ...);
}

constexpr Need kLockedZag{"fill_pattern = lockedzag", HasPattern<FillPattern::kLockedZag>};
/// The defaults of widths depend on the nozzle's diameter.
constexpr Need kLockedZagIfRequested{.what = "fill_pattern = lockedzag",
                                     .met = HasPattern<FillPattern::kLockedZag>,
                                     .only_requested = true};
constexpr Need kShifting{"fill_pattern = crosszag or lockedzag",
                         HasPattern<FillPattern::kCrossZag, FillPattern::kLockedZag>};
constexpr Need kAnyZag{
    "fill_pattern = zigzag, crosszag or lockedzag",
    HasPattern<FillPattern::kZigzag, FillPattern::kCrossZag, FillPattern::kLockedZag>};
constexpr Need kLattice{"fill_pattern = laterallattice", HasPattern<FillPattern::kLateralLattice>};
constexpr Need kLateralHoneycomb{"fill_pattern = lateralhoneycomb",
                                 HasPattern<FillPattern::kLateralHoneycomb>};
constexpr Need kGyroid{"fill_pattern = gyroid", HasPattern<FillPattern::kGyroid>};
constexpr Need kLightning{"fill_pattern = lightning", HasPattern<FillPattern::kLightning>};
constexpr Need kSmoothCorners{
    "a fill_pattern with smooth corners (hilbertcurve, octagramspiral, lightning, honeycomb, "
    "3dhoneycomb, concentric or crosshatch), and no field",
    [](const JobRows& s) {
      const InfillOptions& infill = FdmOf(s).region.infill;
      return (infill.choose_pattern || HasSmoothCorners(infill.pattern)) &&
             infill.density_field.empty() && infill.stress_field.empty();
    }};
constexpr Need kSeveralLines{
    "a fill_pattern with lines that follow from a formula, and no field", [](const JobRows& s) {
      const InfillOptions& infill = FdmOf(s).region.infill;
      return (infill.choose_pattern || TakesSeveralLines(infill.pattern)) &&
             infill.density_field.empty() && infill.stress_field.empty();
    }};

template <auto kMember>
Field Zone() {
  return Bind<&RegionRow::infill, &InfillOptions::zones, kMember>();
}

SettingSpec ZoneDensity(std::string_view key, std::string_view doc, Field field) {
  return {.key = key,
          .kind = Kind::kPercent,
          .unit = "%",
          .min = 0,
          .max = 100,
          .standard = "25%",
          .doc = doc,
          .field = field,
          .orca = {{key, OrcaValue::kPercent}},
          .needs = {&kLockedZag}};
}

SettingSpec ZoneWidth(std::string_view key, std::string_view doc, Field field) {
  return {.key = key,
          .kind = Kind::kNumberOrPercent,
          .unit = "mm",
          .min = 0,
          .max = 20,
          .standard = "100%",
          .doc = doc,
          .relative_to = "nozzle_diameter",
          .field = field,
          .orca = {{key}},
          .needs = {&kLockedZagIfRequested}};
}

SettingSpec ZoneDepth(std::string_view key, std::string_view standard, std::string_view doc,
                      Field field) {
  return {.key = key,
          .unit = "mm",
          .min = 0,
          .max = 1000,
          .standard = standard,
          .doc = doc,
          .field = field,
          .orca = {{key}},
          .needs = {&kLockedZag}};
}

std::vector<SettingSpec> LockedZag() {
  return {
      ZoneDensity("skin_infill_density",
                  "Density of the sparse infill near the walls; replaces fill_density",
                  Bind<Scale::kPercent, &RegionRow::infill, &InfillOptions::zones,
                       &LockedZagOptions::skin_density>()),
      ZoneDensity("skeleton_infill_density",
                  "Density of the sparse infill inside the skin; replaces fill_density",
                  Bind<Scale::kPercent, &RegionRow::infill, &InfillOptions::zones,
                       &LockedZagOptions::skeleton_density>()),
      ZoneDepth("skin_infill_depth", "2", "Depth of the skin of the sparse infill",
                Zone<&LockedZagOptions::skin_depth_nm>()),
      ZoneDepth("infill_lock_depth", "1",
                "Length by which the skeleton of the sparse infill reaches into its skin",
                Zone<&LockedZagOptions::lock_depth_nm>()),
      ZoneWidth("skin_infill_line_width",
                "Extrusion width of the skin of the sparse infill; 0: infill_extrusion_width",
                Zone<&LockedZagOptions::skin_width_nm>()),
      ZoneWidth("skeleton_infill_line_width",
                "Extrusion width of the skeleton of the sparse infill; 0: infill_extrusion_width",
                Zone<&LockedZagOptions::skeleton_width_nm>()),
  };
}

SettingSpec LatticeAngle(std::string_view key, std::string_view standard, Field field) {
  return {.key = key,
          .unit = "degrees",
          .min = -75,
          .max = 75,
          .standard = standard,
          .doc =
              "Inclination of one family of planes of the lattice against the vertical; 0: "
              "upright",
          .field = field,
          .orca = {{key}},
          .needs = {&kLattice}};
}

SettingSpec LightningAngle(std::string_view key, std::string_view doc, Field field) {
  return {.key = key,
          .unit = "degrees",
          .min = 5,
          .max = 85,
          .standard = "45",
          .doc = doc,
          .field = field,
          .orca = {{key}},
          .needs = {&kLightning}};
}

template <auto kMember, Scale kScale = Scale::kSame>
Field Shape() {
  return Bind<kScale, &RegionRow::infill, &InfillOptions::shape, kMember>();
}

std::vector<SettingSpec> Shapes() {
  return {
      {.key = "fill_multiline",
       .kind = Kind::kInteger,
       .min = 1,
       .max = 10,
       .standard = "1",
       .doc = "Number of lines side by side in place of each line of the sparse infill. The lines "
              "are further apart, so that the density remains fill_density",
       .field = Shape<&PatternOptions::lines>(),
       .orca = {{"fill_multiline"}},
       .needs = {&kSeveralLines}},
      LatticeAngle("lateral_lattice_angle_1", "-45",
                   Shape<&PatternOptions::lattice_1_rad, Scale::kDegrees>()),
      LatticeAngle("lateral_lattice_angle_2", "45",
                   Shape<&PatternOptions::lattice_2_rad, Scale::kDegrees>()),
      {.key = "infill_overhang_angle",
       .unit = "degrees",
       .min = 15,
       .max = 75,
       .standard = "60",
       .doc = "Inclination of the sloped walls of the lateral honeycomb against the vertical; 60: "
              "regular hexagons",
       .field = Shape<&PatternOptions::honeycomb_rad, Scale::kDegrees>(),
       .orca = {{"infill_overhang_angle"}},
       .needs = {&kLateralHoneycomb}},
      {.key = "infill_shift_step",
       .unit = "mm",
       .min = 0,
       .max = 10,
       .standard = "0.4",
       .doc = "Distance by which lines of the sparse infill shift from their position two layers "
              "below: to one side in even layers, to the other side in odd layers",
       .field = Shape<&PatternOptions::shift_nm>(),
       .orca = {{"infill_shift_step"}},
       .needs = {&kShifting}},
      {.key = "symmetric_infill_y_axis",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Mirror the lines of the sparse infill in the y axis of the object, for one of two "
              "parts that mirror each other",
       .field = Shape<&PatternOptions::mirrored>(),
       .orca = {{"symmetric_infill_y_axis"}},
       .needs = {&kAnyZag}},
      {.key = "separated_infills",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Lay out the infill of each connected body of an object around the body's middle, as "
              "if the body were printed alone. Without effect on top and bottom surfaces, and on "
              "adaptivecubic, supportcubic, lightning, concentric and fields. 0: around the middle "
              "of the object",
       .field = Shape<&PatternOptions::separated>(),
       .orca = {{"separated_infills"}}},
      {.key = "gyroid_optimized",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc =
           "Change the lengths of the gyroid's waves along and across fill_angle by the density, "
           "so that its walls buckle less under loads; the density remains fill_density",
       .field = Shape<&PatternOptions::stiff_gyroid>(),
       .orca = {{"gyroid_optimized"}},
       .needs = {&kGyroid}},
      {.key = "sparse_infill_smooth_factor",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "0%",
       .doc =
           "Share of the half edges of the sparse infill that round corners take, for a steadier "
           "speed; 100%: the curves of two corners meet in the middle of an edge. The lines are "
           "shorter then, and the density is lower. Patterns: hilbertcurve, octagramspiral, "
           "lightning, honeycomb, 3dhoneycomb, concentric, crosshatch",
       .field = Shape<&PatternOptions::smooth, Scale::kPercent>(),
       .orca = {{"sparse_infill_smooth_factor", OrcaValue::kPercent}},
       .needs = {&kSmoothCorners}},
      LightningAngle(
          "lightning_overhang_angle",
          "Overhang of solid infill, from the vertical, that walls hold without lightning "
          "infill. 45: solid infill up to the distance of the lines from a wall; other "
          "angles change this distance by as much as an overhang of the angle is longer "
          "in one layer",
          Shape<&PatternOptions::lightning_overhang_rad, Scale::kDegrees>()),
      LightningAngle("lightning_prune_angle",
                     "Largest angle, from the vertical, at which the branches of lightning infill "
                     "become shorter downwards; larger: fewer branches",
                     Shape<&PatternOptions::lightning_prune_rad, Scale::kDegrees>()),
      LightningAngle("lightning_straightening_angle",
                     "Largest angle, from the vertical, at which the branches of lightning infill "
                     "become straighter downwards; larger: shorter lines",
                     Shape<&PatternOptions::lightning_straighten_rad, Scale::kDegrees>()),
  };
}

}  // namespace

std::vector<SettingSpec> PatternSettings() {
  std::vector<SettingSpec> settings = Shapes();
  for (SettingSpec& zone : LockedZag()) settings.push_back(std::move(zone));
  return settings;
}

}  // namespace slicefarm::config::fdm
