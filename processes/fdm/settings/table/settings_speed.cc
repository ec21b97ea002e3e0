#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

constexpr double kMaxSpeed = 10'000;

template <Feature kFeature>
Field SpeedOf() {
  return Bind<&RegionRow::motion, &RegionMotion::speed_mm_s, static_cast<int>(kFeature)>();
}

SettingSpec Speed(std::string_view key, std::string_view standard, std::string_view doc,
                  Field field, Field also = {}) {
  return {.key = key,
          .unit = "mm/s",
          .min = 0,
          .max = kMaxSpeed,
          .standard = standard,
          .doc = doc,
          .field = field,
          .also = also};
}

SettingSpec RelativeSpeed(std::string_view key, std::string_view standard, std::string_view to,
                          std::string_view doc, Field field) {
  SettingSpec spec = Speed(key, standard, doc, field);
  spec.kind = Kind::kNumberOrPercent;
  spec.relative_to = to;
  return spec;
}

/// Returns a speed setting: mm/s, or a percentage of the speed of each feature.
template <double MachineMotion::*kSpeed, double MachineMotion::*kRatio>
SettingSpec LayerSpeed(std::string_view key, std::string_view doc) {
  const auto set = [](MachineRow& row, const Value& value) {
    row.motion.*kSpeed = value.percent ? 0 : value.number;
    row.motion.*kRatio = value.percent && value.number > 0 ? value.number / 100 : 1;
  };
  const auto get = [](const MachineRow& row) -> Value {
    if (row.motion.*kSpeed != 0) return {.number = row.motion.*kSpeed};
    return {.number = Quantise(row.motion.*kRatio * 100), .percent = true};
  };
  return {.key = key,
          .kind = Kind::kNumberOrPercent,
          .unit = "mm/s",
          .min = 0,
          .max = kMaxSpeed,
          .standard = "30",
          .doc = doc,
          .percent_of = "the speed in other layers",
          .field = Convert<MachineRow>(set, get)};
}

template <int kDegree>
SettingSpec OverhangSpeed(std::string_view key, std::string_view standard, std::string_view doc) {
  return RelativeSpeed(key, standard, "external_perimeter_speed", doc,
                       Bind<&RegionRow::motion, &RegionMotion::overhang_speed_mm_s, kDegree>());
}

std::vector<SettingSpec> Overhangs() {
  return {
      {.key = "overhangs",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Print walls that overhang with their full width as bridges, with the speed, fan "
              "speed and flow of bridges; 0: as other walls",
       .field = Bind<&RegionRow::motion, &RegionMotion::bridging_walls>(),
       .orca = {{"detect_overhang_wall"}}},
      {.key = "enable_dynamic_overhang_speeds",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Slow overhanging walls down to the speeds in overhang_speed_0 to overhang_speed_3, "
              "interpolated between them; 0: overhanging walls have the speed of other walls",
       .field = Bind<&RegionRow::motion, &RegionMotion::dynamic_overhangs>(),
       .orca = {{"enable_overhang_speed"}}},
      {.key = "slowdown_for_curled_perimeters",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Slow walls down to overhang_speed_2 above edges that have probably curled up by "
              "more than 0.1 mm; 0: full speed above such edges",
       .field = Bind<&MachineRow::motion, &MachineMotion::slow_curled>(),
       .also = Bind<&MachineRow::plan, &JobPlanOptions::slow_curled>(),
       .orca = {{"slowdown_for_curled_perimeters"}},
       .needs = {&needs::kDynamicOverhangs}},
      Orca({"overhang_4_4_speed"},
           OverhangSpeed<0>("overhang_speed_0", "15",
                            "Speed of walls that overhang with their full width, with "
                            "enable_dynamic_overhang_speeds = 1; 0: not slowed down")),
      Orca({"overhang_3_4_speed"},
           OverhangSpeed<1>("overhang_speed_1", "15",
                            "Speed of walls with 25 % of their width on the layer below, with "
                            "enable_dynamic_overhang_speeds = 1; 0: not slowed down")),
      Orca({"overhang_2_4_speed"},
           OverhangSpeed<2>("overhang_speed_2", "20",
                            "Speed of walls with 50 % of their width on the layer below, with "
                            "enable_dynamic_overhang_speeds = 1; 0: not slowed down")),
      Orca({"overhang_1_4_speed"},
           OverhangSpeed<3>("overhang_speed_3", "25",
                            "Speed of walls with 75 % of their width on the layer below, with "
                            "enable_dynamic_overhang_speeds = 1; 0: not slowed down")),
  };
}

SettingSpec FlowSlope(std::string_view key, std::string_view doc, Field field) {
  return {.key = key,
          .unit = "mm3/s2",
          .min = 0,
          .max = 1e6,
          .standard = "0",
          .doc = doc,
          .field = field,
          .orca = {{"max_volumetric_extrusion_rate_slope"}}};
}

/// Returns the speed of infill over bridges. This infill is a separate feature only if it has its
/// own speed.
SettingSpec OverBridgeSpeed() {
  SettingSpec spec =
      RelativeSpeed("over_bridge_speed", "0", "solid_infill_speed",
                    "Speed of solid infill in the layer above a bridge; 0: solid_infill_speed",
                    SpeedOf<Feature::kSolidOverBridge>());
  spec.also = Convert<RegionRow>(
      [](RegionRow& row, const Value& value) { row.infill.over_bridges = value.number > 0; },
      [](const RegionRow&) { return Value(); });
  spec.also.get = spec.field.get;
  return spec;
}

/// Returns the speed of bridges over sparse infill. These bridges are a separate feature only if
/// they have their own speed.
SettingSpec InternalBridgeSpeed() {
  SettingSpec spec = Orca({"internal_bridge_speed"},
                          RelativeSpeed("internal_bridge_speed", "0", "bridge_speed",
                                        "Speed of bridges over sparse infill, in the first solid "
                                        "layer above the sparse infill; 0: bridge_speed",
                                        SpeedOf<Feature::kInternalBridge>()));
  spec.also = Convert<RegionRow>(
      [](RegionRow& row, const Value& value) { row.infill.internal_bridges = value.number > 0; },
      [](const RegionRow&) { return Value(); });
  spec.also.get = spec.field.get;
  return spec;
}

/// Returns the speed of small loops of supports: mm/s, or a percentage of the supports' speed.
SettingSpec SmallSupportSpeed() {
  const auto set = [](RegionRow& row, const Value& value) {
    row.motion.small_support_mm_s = value.percent ? 0 : value.number;
    row.motion.small_support_ratio = value.percent && value.number > 0 ? value.number / 100 : 0.5;
  };
  const auto get = [](const RegionRow& row) -> Value {
    const RegionMotion& motion = row.motion;
    if (motion.small_support_mm_s != 0) return {.number = motion.small_support_mm_s};
    return {.number = Quantise(motion.small_support_ratio * 100), .percent = true};
  };
  return {.key = "small_support_perimeter_speed",
          .kind = Kind::kNumberOrPercent,
          .unit = "mm/s",
          .min = 0.1,
          .max = 10'000,
          .standard = "50%",
          .doc =
              "Speed of loops of supports with a radius of small_support_perimeter_threshold or "
              "less",
          .percent_of = "the speed of the supports",
          .field = Convert<RegionRow>(set, get),
          .own_scope = Scope::kObject,
          .orca = {{"small_support_perimeter_speed", OrcaValue::kOrAuto, "0"}}};
}

std::vector<SettingSpec> Speeds() {
  return {
      Orca({"inner_wall_speed"},
           Speed("perimeter_speed", "60", "Speed of inner walls; 0: max_print_speed",
                 SpeedOf<Feature::kPerimeter>())),
      Orca({"outer_wall_speed"}, RelativeSpeed("external_perimeter_speed", "50%", "perimeter_speed",
                                               "Speed of outer walls; 0: max_print_speed",
                                               SpeedOf<Feature::kExternalPerimeter>())),
      Orca({"small_perimeter_speed"},
           RelativeSpeed("small_perimeter_speed", "15", "perimeter_speed",
                         "Speed of small loops of walls: loops no longer than a circle with the "
                         "radius small_perimeter_threshold; 0: max_print_speed",
                         Bind<&RegionRow::motion, &RegionMotion::small_perimeter_speed_mm_s>())),
      {.key = "small_perimeter_threshold",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "6.5",
       .doc = "Radius of the largest circle that is printed at small_perimeter_speed, as are other "
              "loops of walls of the same length; 0: no loops. Default in OrcaSlicer: 0",
       .field = Bind<&RegionRow::motion, &RegionMotion::small_perimeter_radius_mm>(),
       .orca = {{"small_perimeter_threshold"}}},
      SmallSupportSpeed(),
      {.key = "small_support_perimeter_threshold",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "Radius of the largest loops of supports that are printed at "
              "small_support_perimeter_speed; 0: no loops",
       .field = Bind<&RegionRow::motion, &RegionMotion::small_support_radius_mm>(),
       .own_scope = Scope::kObject,
       .orca = {{"small_support_perimeter_threshold"}}},
      Orca({"sparse_infill_speed"},
           Speed("infill_speed", "80", "Speed of sparse infill; 0: max_print_speed",
                 SpeedOf<Feature::kInternalInfill>())),
      Orca({"internal_solid_infill_speed"},
           RelativeSpeed("solid_infill_speed", "20", "infill_speed",
                         "Speed of solid infill; 0: max_print_speed",
                         SpeedOf<Feature::kSolidInfill>())),
      Orca({"top_surface_speed"},
           RelativeSpeed("top_solid_infill_speed", "15", "solid_infill_speed",
                         "Speed of top surfaces; 0: max_print_speed",
                         SpeedOf<Feature::kTopSolidInfill>())),
      OverBridgeSpeed(),
      Orca({"gap_infill_speed"},
           Speed("gap_fill_speed", "20", "Speed of gap fill; 0: max_print_speed",
                 SpeedOf<Feature::kGapFill>())),
      Orca({"bridge_speed"},
           Speed("bridge_speed", "60", "Speed of bridges; 0: max_print_speed",
                 SpeedOf<Feature::kBridgeInfill>(), SpeedOf<Feature::kOverhangPerimeter>())),
      InternalBridgeSpeed(),
      InScope(Scope::kObject,
              Orca({"support_speed"},
                   Speed("support_material_speed", "60",
                         "Speed of supports, rafts, skirt and brim; 0: max_print_speed",
                         SpeedOf<Feature::kSupport>(), SpeedOf<Feature::kSkirt>()))),
      InScope(
          Scope::kObject,
          Orca(
              {"support_interface_speed"},
              RelativeSpeed(
                  "support_material_interface_speed", "100%", "support_material_speed",
                  "Speed of support interfaces and of the top layers of a raft; 0: max_print_speed",
                  SpeedOf<Feature::kSupportInterface>()))),
      Orca({"ironing_speed"},
           Needing({&needs::kAnyIroning},
                   Speed("ironing_speed", "15", "Speed of ironing; 0: max_print_speed",
                         SpeedOf<Feature::kIroning>()))),
      Orca({"initial_layer_speed"},
           LayerSpeed<&MachineMotion::first_layer_speed_mm_s,
                      &MachineMotion::first_layer_speed_ratio>(
               "first_layer_speed",
               "Speed of all extrusion in the first layer; a percentage is taken of the speed in "
               "other layers. 0: as in other layers")),
      Orca({"initial_layer_infill_speed"},
           RelativeSpeed(
               "first_layer_infill_speed", "0", "solid_infill_speed",
               "Speed of solid infill in the first layer; 0: first_layer_speed",
               Bind<&MachineRow::motion, &MachineMotion::first_layer_infill_speed_mm_s>())),
      LayerSpeed<&MachineMotion::over_raft_speed_mm_s, &MachineMotion::over_raft_speed_ratio>(
          "first_layer_speed_over_raft",
          "Speed of all extrusion in an object's first layer on a raft; a percentage is taken of "
          "the speed in other layers. 0: as in other layers"),
      {.key = "slow_down_layers",
       .kind = Kind::kInteger,
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "Number of layers over which speeds rise evenly from the speeds of the first layer "
              "(first_layer_speed, first_layer_infill_speed) to the speeds of other layers. 0 and "
              "1: full speed from the second layer on",
       .field = Bind<&MachineRow::motion, &MachineMotion::slow_down_layers>(),
       .orca = {{"slow_down_layers"}}},
      {.key = "max_print_speed",
       .unit = "mm/s",
       .min = 1,
       .max = kMaxSpeed,
       .standard = "80",
       .doc = "Speed of all lines that have 0 in their own speed setting",
       .field = Bind<&MachineRow::motion, &MachineMotion::max_print_speed_mm_s>()},
      {.key = "travel_speed",
       .unit = "mm/s",
       .min = 1,
       .max = kMaxSpeed,
       .standard = "130",
       .doc = "Speed of travels",
       .field = Bind<&MachineRow::motion, &MachineMotion::travel_speed_mm_s>(),
       .orca = {{"travel_speed"}}},
      Orca({"initial_layer_travel_speed", OrcaValue::kPercentOf, "travel_speed"},
           Speed("first_layer_travel_speed", "0",
                 "Speed of travels in the first layer; 0: travel_speed",
                 Bind<&MachineRow::motion, &MachineMotion::first_layer_travel_speed_mm_s>())),
      Orca({"travel_speed_z"},
           Speed("travel_speed_z", "0", "Speed of vertical travels; 0: machine_max_feedrate_z",
                 Bind<&MachineRow::motion, &MachineMotion::travel_speed_z_mm_s>())),
      {.key = "max_volumetric_speed",
       .unit = "mm3/s",
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "Highest volume that is extruded per second; faster lines are slowed down. "
              "filament_max_volumetric_speed is a second limit. 0: no limit"},
      FlowSlope("max_volumetric_extrusion_rate_slope_positive",
                "Largest increase of the extruded volume per second along a path; fast lines after "
                "slower lines are slowed down gradually. 0: no limit",
                Bind<&MachineRow::motion, &MachineMotion::flow_rise_mm3_s2>()),
      {.key = "max_volumetric_extrusion_rate_slope_segment_length",
       .unit = "mm",
       .min = 0.1,
       .max = 100,
       .standard = "1",
       .doc = "Length of the pieces into which lines are divided where "
              "max_volumetric_extrusion_rate_slope_positive or _negative changes the flow; "
              "smaller: smoother, but more G-code",
       .field = Bind<&MachineRow::motion, &MachineMotion::flow_segment_mm>(),
       .orca = {{"max_volumetric_extrusion_rate_slope_segment_length"}},
       .needs = {&needs::kFlowSlope}},
      FlowSlope("max_volumetric_extrusion_rate_slope_negative",
                "Largest decrease of the extruded volume per second along a path; fast lines "
                "before slower lines are slowed down gradually. 0: no limit",
                Bind<&MachineRow::motion, &MachineMotion::flow_fall_mm3_s2>()),
  };
}

}  // namespace

std::vector<SettingSpec> SpeedSettings() {
  std::vector<SettingSpec> settings = Speeds();
  for (auto part : {Overhangs(), DynamicsSettings()})
    for (SettingSpec& spec : part) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
