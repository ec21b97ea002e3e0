#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

constexpr double kMaxAcceleration = 1e6;
constexpr double kMaxJerk = 1000;

template <Feature kFeature>
Field AccelerationOf() {
  return Bind<&MachineRow::motion, &MachineMotion::acceleration_mm_s2,
              static_cast<int>(kFeature)>();
}

SettingSpec Acceleration(std::string_view key, std::string_view doc, Field field, Field also = {}) {
  return {.key = key,
          .unit = "mm/s2",
          .min = 0,
          .max = kMaxAcceleration,
          .standard = "0",
          .doc = doc,
          .field = field,
          .also = also};
}

/// Returns the field for the acceleration of walls over air and of bridges over sparse infill.
Field OtherBridgesAcceleration() {
  constexpr auto kWalls = static_cast<size_t>(Feature::kOverhangPerimeter);
  constexpr auto kInternal = static_cast<size_t>(Feature::kInternalBridge);
  return Convert<MachineRow>(
      [](MachineRow& row, const Value& value) {
        row.motion.acceleration_mm_s2[kWalls] = row.motion.acceleration_mm_s2[kInternal] =
            value.number;
      },
      [](const MachineRow& row) { return Value{.number = row.motion.acceleration_mm_s2[kWalls]}; });
}

std::vector<SettingSpec> Accelerations() {
  return {
      Orca({"default_acceleration"},
           Acceleration(
               "default_acceleration",
               "Acceleration of lines that have 0 in their own acceleration setting; 0: no "
               "accelerations are written, so that the firmware's value applies to all lines",
               Bind<&MachineRow::motion, &MachineMotion::default_acceleration_mm_s2>())),
      Orca({"inner_wall_acceleration", OrcaValue::kPercentOf, "default_acceleration"},
           Needing({&needs::kDefaultAcceleration},
                   Acceleration("perimeter_acceleration",
                                "Acceleration of inner walls; 0: default_acceleration",
                                AccelerationOf<Feature::kPerimeter>()))),
      Orca({"outer_wall_acceleration", OrcaValue::kPercentOf, "default_acceleration"},
           Needing({&needs::kDefaultAcceleration},
                   Acceleration("external_perimeter_acceleration",
                                "Acceleration of outer walls; 0: perimeter_acceleration",
                                AccelerationOf<Feature::kExternalPerimeter>()))),
      Orca({"sparse_infill_acceleration", OrcaValue::kPercentOf, "default_acceleration"},
           Needing({&needs::kDefaultAcceleration},
                   Acceleration("infill_acceleration",
                                "Acceleration of sparse infill; 0: default_acceleration",
                                AccelerationOf<Feature::kInternalInfill>()))),
      Orca({"internal_solid_infill_acceleration", OrcaValue::kPercentOf, "default_acceleration"},
           Needing({&needs::kDefaultAcceleration},
                   Acceleration("solid_infill_acceleration",
                                "Acceleration of solid infill; 0: infill_acceleration",
                                AccelerationOf<Feature::kSolidInfill>(),
                                AccelerationOf<Feature::kSolidOverBridge>()))),
      Orca({"top_surface_acceleration", OrcaValue::kPercentOf, "default_acceleration"},
           Needing({&needs::kDefaultAcceleration},
                   Acceleration("top_solid_infill_acceleration",
                                "Acceleration of top surfaces; 0: solid_infill_acceleration",
                                AccelerationOf<Feature::kTopSolidInfill>()))),
      Orca({"bridge_acceleration", OrcaValue::kPercentOf, "outer_wall_acceleration"},
           Needing({&needs::kDefaultAcceleration},
                   Acceleration(
                       "bridge_acceleration", "Acceleration of bridges; 0: default_acceleration",
                       AccelerationOf<Feature::kBridgeInfill>(), OtherBridgesAcceleration()))),
      Orca({"initial_layer_acceleration"},
           Needing(
               {&needs::kDefaultAcceleration},
               Acceleration(
                   "first_layer_acceleration",
                   "Acceleration of all extrusion in the first layer; 0: as in other layers",
                   Bind<&MachineRow::motion, &MachineMotion::first_layer_acceleration_mm_s2>()))),
      Acceleration("first_layer_acceleration_over_raft",
                   "Acceleration of all extrusion in an object's first layer on a raft; 0: as in "
                   "other layers",
                   Bind<&MachineRow::motion, &MachineMotion::over_raft_acceleration_mm_s2>()),
      Needing({&needs::kTravelAcceleration},
              Acceleration(
                  "travel_short_distance_acceleration",
                  "Acceleration of travels that lead to an outer wall and are shorter than "
                  "retract_before_travel; 0: travel_acceleration",
                  Bind<&MachineRow::motion, &MachineMotion::short_travel_acceleration_mm_s2>())),
      Orca({"travel_acceleration"},
           Needing({&needs::kDefaultAcceleration},
                   Acceleration(
                       "travel_acceleration",
                       "Acceleration of travels; 0: machine_max_acceleration_travel",
                       Bind<&MachineRow::motion, &MachineMotion::travel_acceleration_mm_s2>()))),
      Orca(
          {"initial_layer_travel_acceleration", OrcaValue::kPercentOf, "travel_acceleration"},
          Needing({&needs::kTravelAcceleration},
                  Acceleration("first_layer_travel_acceleration",
                               "Acceleration of travels in the first layer; 0: travel_acceleration",
                               Bind<&MachineRow::motion,
                                    &MachineMotion::first_layer_travel_acceleration_mm_s2>()))),
      {.key = "accel_to_decel",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "0",
       .doc = "Acceleration of moves that are too short to reach their speed, as a percentage of "
              "the normal acceleration (ACCEL_TO_DECEL and MINIMUM_CRUISE_RATIO of Klipper). 100: "
              "the normal acceleration. 0: Klipper's own value, because no command is written",
       .field = Bind<Scale::kPercent, &MachineRow::motion, &MachineMotion::accel_to_decel>(),
       .needs = {&needs::kKlipper}},
  };
}

SettingSpec Jerk(std::string_view key, std::string_view doc, Field field) {
  return {.key = key,
          .unit = "mm/s",
          .min = 0,
          .max = kMaxJerk,
          .standard = "0",
          .doc = doc,
          .field = field};
}

template <double JerkOptions::*kJerk>
Field JerkField() {
  return Bind<&MachineRow::motion, &MachineMotion::jerk, kJerk>();
}

template <Feature kFeature>
Field JerkOf() {
  return Bind<&MachineRow::motion, &MachineMotion::jerk, &JerkOptions::feature_mm_s,
              static_cast<int>(kFeature)>();
}

/// Returns the field for the jerk of all infill except top surfaces.
Field InfillJerk() {
  return Convert<MachineRow>(
      [](MachineRow& row, const Value& value) {
        for (const Feature feature :
             {Feature::kInternalInfill, Feature::kSolidInfill, Feature::kSolidOverBridge,
              Feature::kBridgeInfill, Feature::kInternalBridge, Feature::kIroning})
          row.motion.jerk.feature_mm_s[static_cast<size_t>(feature)] = value.number;
      },
      [](const MachineRow& row) {
        constexpr auto kSparse = static_cast<size_t>(Feature::kInternalInfill);
        return Value{.number = row.motion.jerk.feature_mm_s[kSparse]};
      });
}

std::vector<SettingSpec> Jerks() {
  return {
      Orca({"default_jerk"},
           Jerk("default_jerk",
                "Jerk in x and y (M205, M566), or square corner velocity (Klipper), of lines that "
                "have 0 in their own jerk setting. machine_max_jerk_x and machine_max_jerk_y limit "
                "this value. 0: no jerk is written, so that the firmware's value applies to all "
                "lines",
                JerkField<&JerkOptions::default_mm_s>())),
      Orca({"inner_wall_jerk"},
           Needing({&needs::kDefaultJerk},
                   Jerk("perimeter_jerk", "Jerk of inner walls; 0: default_jerk",
                        JerkOf<Feature::kPerimeter>()))),
      Orca({"outer_wall_jerk"},
           Needing({&needs::kDefaultJerk},
                   Jerk("external_perimeter_jerk", "Jerk of outer walls; 0: default_jerk",
                        JerkOf<Feature::kExternalPerimeter>()))),
      Orca({"infill_jerk"},
           Needing({&needs::kDefaultJerk},
                   Jerk("infill_jerk", "Jerk of infill, bridges and ironing; 0: default_jerk",
                        InfillJerk()))),
      Orca({"top_surface_jerk"},
           Needing({&needs::kDefaultJerk},
                   Jerk("top_solid_infill_jerk", "Jerk of top surfaces; 0: default_jerk",
                        JerkOf<Feature::kTopSolidInfill>()))),
      Orca({"initial_layer_jerk"},
           Needing({&needs::kDefaultJerk},
                   Jerk("first_layer_jerk",
                        "Jerk of all moves in the first layer; 0: as in other layers",
                        JerkField<&JerkOptions::first_layer_mm_s>()))),
      Orca({"travel_jerk"},
           Needing({&needs::kDefaultJerk},
                   Jerk("travel_jerk", "Jerk of travels; 0: the jerk of the line before the travel",
                        JerkField<&JerkOptions::travel_mm_s>()))),
      Orca(
          {"initial_layer_travel_jerk", OrcaValue::kPercentOf, "travel_jerk"},
          Needing(
              {&needs::kDefaultJerk},
              Jerk(
                  "first_layer_travel_jerk",
                  "Jerk of travels in the first layer; 0: first_layer_jerk, or travel_jerk if both "
                  "are 0",
                  JerkField<&JerkOptions::first_layer_travel_mm_s>()))),
      {.key = "default_junction_deviation",
       .unit = "mm",
       .min = 0,
       .max = 1,
       .standard = "0",
       .doc = "Junction deviation that is set at the start of the print (M205 J of Marlin 2); "
              "larger: faster through corners. machine_max_junction_deviation limits it. 0: the "
              "firmware's value",
       .field = JerkField<&JerkOptions::junction_deviation_mm>(),
       .orca = {{"default_junction_deviation"}},
       .needs = {&needs::kJunctionDeviation}},
  };
}

std::vector<SettingSpec> Resonance() {
  const auto speed = [](std::string_view key, std::string_view standard, std::string_view doc,
                        Field field, OrcaName orca) {
    return SettingSpec{.key = key,
                       .unit = "mm/s",
                       .min = 0,
                       .max = 10'000,
                       .standard = standard,
                       .doc = doc,
                       .field = field,
                       .orca = {orca},
                       .needs = {&needs::kResonance}};
  };
  return {
      {.key = "resonance_avoidance",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print outer walls at min_resonance_avoidance_speed if their speed is between "
              "min_resonance_avoidance_speed and max_resonance_avoidance_speed",
       .field = Bind<&MachineRow::motion, &MachineMotion::resonance, &ResonanceOptions::avoid>(),
       .orca = {{"resonance_avoidance"}}},
      speed("min_resonance_avoidance_speed", "70", "Lowest speed at which the machine resonates",
            Bind<&MachineRow::motion, &MachineMotion::resonance, &ResonanceOptions::from_mm_s>(),
            {"min_resonance_avoidance_speed"}),
      speed("max_resonance_avoidance_speed", "120", "Highest speed at which the machine resonates",
            Bind<&MachineRow::motion, &MachineMotion::resonance, &ResonanceOptions::until_mm_s>(),
            {"max_resonance_avoidance_speed"}),
      {.key = "extrusion_rate_smoothing_external_perimeter_only",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Apply max_volumetric_extrusion_rate_slope_positive and _negative to outer walls and "
              "walls over air only",
       .field = Bind<&MachineRow::motion, &MachineMotion::flow_slopes_of_outer_walls>(),
       .orca = {{"extrusion_rate_smoothing_external_perimeter_only"}},
       .needs = {&needs::kFlowSlope}},
  };
}

}  // namespace

std::vector<SettingSpec> DynamicsSettings() {
  std::vector<SettingSpec> settings = Accelerations();
  for (auto part : {Jerks(), Resonance()})
    for (SettingSpec& spec : part) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
