#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

SettingSpec PerExtruder(SettingSpec spec) {
  spec.list = List::kPerExtruder;
  return spec;
}

/// Returns a shrinkage setting. ResolvePlate scales objects with it; stages do not use it.
SettingSpec Shrinkage(std::string_view key, std::string_view doc) {
  return PerExtruder({.key = key,
                      .kind = Kind::kPercent,
                      .unit = "%",
                      .min = -10,
                      .max = 10,
                      .standard = "0%",
                      .doc = doc});
}

std::vector<SettingSpec> Temperatures() {
  const auto temperature = [](std::string_view key, std::string_view standard, double max,
                              std::string_view doc, Field field) {
    return PerExtruder({.key = key,
                        .kind = Kind::kInteger,
                        .unit = "C",
                        .min = 0,
                        .max = max,
                        .standard = standard,
                        .doc = doc,
                        .field = field});
  };
  return {
      Orca({"nozzle_temperature"},
           temperature("temperature", "200", 600,
                       "Nozzle temperature after the first layer; 0: not set",
                       Bind<&ToolRow::temperature_c>())),
      Orca({"nozzle_temperature_initial_layer"},
           temperature("first_layer_temperature", "200", 600,
                       "Nozzle temperature of the first layer; 0: not set",
                       Bind<&ToolRow::first_layer_temperature_c>())),
      temperature("bed_temperature", "0", 300, "Bed temperature after the first layer; 0: not set",
                  Bind<&ToolRow::bed_temperature_c>()),
      temperature("first_layer_bed_temperature", "0", 300,
                  "Bed temperature of the first layer; 0: not set",
                  Bind<&ToolRow::first_layer_bed_temperature_c>()),
  };
}

template <int kDegree>
SettingSpec OverhangFan(std::string_view key, std::string_view doc) {
  return PerExtruder(
      {.key = key,
       .kind = Kind::kInteger,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "0",
       .doc = doc,
       .field = Bind<&ToolRow::cooling, &CoolingOptions::overhang_fan_percent, kDegree>()});
}

std::vector<SettingSpec> Cooling() {
  const auto flag = [](std::string_view key, std::string_view standard, std::string_view doc,
                       Field field) {
    return PerExtruder(
        {.key = key, .kind = Kind::kFlag, .standard = standard, .doc = doc, .field = field});
  };
  const auto whole = [](std::string_view key, std::string_view unit, double max,
                        std::string_view standard, std::string_view doc, Field field) {
    return PerExtruder({.key = key,
                        .kind = Kind::kInteger,
                        .unit = unit,
                        .min = 0,
                        .max = max,
                        .standard = standard,
                        .doc = doc,
                        .field = field});
  };
  return {
      Orca({"slow_down_for_layer_cooling"},
           flag("cooling", "1", "Slows short layers down and drives the fan by the layer's time",
                Bind<&ToolRow::cooling, &CoolingOptions::enabled>())),
      Orca({"reduce_fan_stop_start_freq"},
           flag("fan_always_on", "0", "Keeps the fan at min_fan_speed at least",
                Bind<&ToolRow::cooling, &CoolingOptions::fan_always_on>())),
      Orca({"fan_min_speed"},
           whole("min_fan_speed", "%", 100, "35", "Fan at layers as long as fan_below_layer_time",
                 Bind<&ToolRow::cooling, &CoolingOptions::min_fan_percent>())),
      Orca({"fan_max_speed"}, whole("max_fan_speed", "%", 100, "100",
                                    "Fan at layers as short as slowdown_below_layer_time",
                                    Bind<&ToolRow::cooling, &CoolingOptions::max_fan_percent>())),
      Orca({"overhang_fan_speed"},
           whole("bridge_fan_speed", "%", 100, "100", "Fan at bridges",
                 Bind<&ToolRow::cooling, &CoolingOptions::bridge_fan_percent>())),
      Orca({"close_fan_the_first_x_layers"},
           whole("disable_fan_first_layers", "layers", 1000, "3",
                 "The fan is off in this many layers",
                 Bind<&ToolRow::cooling, &CoolingOptions::disable_fan_first_layers>())),
      Orca(
          {"full_fan_speed_layer"},
          whole("full_fan_speed_layer", "layers", 100'000, "0",
                "From disable_fan_first_layers on the fan's share grows until this layer; 0: it is "
                "full at "
                "once",
                Bind<&ToolRow::cooling, &CoolingOptions::full_fan_speed_layer>())),
      flag("enable_dynamic_fan_speeds", "0",
           "Sets the fan where walls hang over the layer below, by overhang_fan_speed_0 to _3, and "
           "between these in proportion",
           Bind<&ToolRow::cooling, &CoolingOptions::dynamic_fan>()),
      OverhangFan<0>("overhang_fan_speed_0", "Fan at walls that rest on nothing"),
      OverhangFan<1>("overhang_fan_speed_1", "Fan where 25 % of the width rest on the layer below"),
      OverhangFan<2>("overhang_fan_speed_2", "Fan where 50 % of the width rest on it"),
      OverhangFan<3>("overhang_fan_speed_3", "Fan where 75 % of the width rest on it"),
      Orca(
          {"fan_cooling_layer_time"},
          whole("fan_below_layer_time", "s", 1000, "60", "The fan runs at layers shorter than this",
                Bind<&ToolRow::cooling, &CoolingOptions::fan_below_layer_time_s>())),
      Orca({"slow_down_layer_time"},
           whole("slowdown_below_layer_time", "s", 1000, "5",
                 "Shorter layers are slowed down to this",
                 Bind<&ToolRow::cooling, &CoolingOptions::slowdown_below_layer_time_s>())),
      PerExtruder(
          {.key = "cooling_slowdown_logic",
           .kind = Kind::kChoice,
           .standard = "uniform_cooling",
           .doc = "What is slowed down in short layers: all beads alike (uniform_cooling), or "
                  "all but the outer walls first, so that these look alike (consistent_surface)",
           .choices = {{"uniform_cooling", 0}, {"consistent_surface", 1}},
           .field = Bind<&ToolRow::cooling, &CoolingOptions::consistent_surface>()}),
      PerExtruder({.key = "cooling_perimeter_transition_distance",
                   .unit = "mm",
                   .min = 0,
                   .max = 1000,
                   .standard = "0",
                   .doc = "How long before walls that are not slowed down the speed is back, with "
                          "cooling_slowdown_logic = consistent_surface",
                   .field = Bind<&ToolRow::cooling, &CoolingOptions::transition_mm>()}),
      PerExtruder({.key = "min_print_speed",
                   .unit = "mm/s",
                   .min = 0,
                   .max = 1000,
                   .standard = "10",
                   .doc = "Short layers are not slowed down below this",
                   .field = Bind<&ToolRow::cooling, &CoolingOptions::min_print_speed_mm_s>(),
                   .orca = {{"slow_down_min_speed"}}}),
  };
}

std::vector<SettingSpec> Material() {
  const auto text = [](std::string_view key, std::string_view standard, std::string_view doc,
                       Field field) {
    return PerExtruder(
        {.key = key, .kind = Kind::kText, .standard = standard, .doc = doc, .field = field});
  };
  return {
      PerExtruder({.key = "chamber_temperature",
                   .kind = Kind::kInteger,
                   .unit = "C",
                   .min = 0,
                   .max = 1000,
                   .standard = "0",
                   .doc = "Temperature of the chamber; 0: left as it is",
                   .field = Bind<&ToolRow::chamber_temperature_c>(),
                   .orca = {{"chamber_temperature"}}}),
      {.key = "activate_chamber_temp_control",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Heats the chamber (M141, M191); 0: its temperature is there for G-code of the "
              "settings alone",
       .field = Bind<&MachineRow::motion, &MachineMotion::heats_chamber>()},
      PerExtruder({.key = "chamber_minimal_temperature",
                   .kind = Kind::kInteger,
                   .unit = "C",
                   .min = 0,
                   .max = 1000,
                   .standard = "0",
                   .doc = "Temperature of the chamber that the print waits for; 0: it does not",
                   .field = Bind<&ToolRow::chamber_least_c>(),
                   .orca = {{"chamber_minimal_temperature"}}}),
      PerExtruder({.key = "filament_infill_max_speed",
                   .unit = "mm/s",
                   .min = 0,
                   .max = 10'000,
                   .standard = "0",
                   .doc = "Most that the filament stands in sparse infill; 0: no limit"}),
      PerExtruder({.key = "filament_infill_max_crossing_speed",
                   .unit = "mm/s",
                   .min = 0,
                   .max = 10'000,
                   .standard = "0",
                   .doc = "Most that it stands in sparse infill whose lines cross; 0: no limit"}),
      PerExtruder({.key = "filament_diameter",
                   .unit = "mm",
                   .min = 0.1,
                   .max = 100,
                   .standard = "1.75",
                   .doc = "Diameter of the filament",
                   .field = Bind<&ToolRow::filament_diameter_mm>(),
                   .orca = {{"filament_diameter"}}}),
      PerExtruder({.key = "extrusion_multiplier",
                   .min = 0.01,
                   .max = 10,
                   .standard = "1",
                   .doc = "Times the filament that a bead's volume asks for",
                   .field = Bind<&ToolRow::extrusion_multiplier>(),
                   .orca = {{"filament_flow_ratio"}}}),
      Orca({"filament_shrink", OrcaValue::kRest},
           Shrinkage(
               "filament_shrinkage_compensation_xy",
               "How much the filament shrinks as it cools, in x and y: parts are printed larger by "
               "it; 1% for 99 mm that should be 100 mm")),
      Orca({"filament_shrinkage_compensation_z", OrcaValue::kRest},
           Shrinkage(
               "filament_shrinkage_compensation_z",
               "How much the filament shrinks as it cools, in height: parts are printed higher")),
      PerExtruder({.key = "filament_density",
                   .unit = "g/cm3",
                   .min = 0,
                   .max = 30,
                   .standard = "1.24",
                   .doc = "Density of the filament: for the mass in the report",
                   .field = Bind<&ToolRow::filament_density_g_cm3>(),
                   .orca = {{"filament_density"}}}),
      PerExtruder({.key = "filament_cost",
                   .unit = "money/kg",
                   .min = 0,
                   .max = 1e6,
                   .standard = "0",
                   .doc = "Cost of the filament: for the cost in the report",
                   .field = Bind<&ToolRow::filament_cost_per_kg>(),
                   .orca = {{"filament_cost"}}}),
      PerExtruder({.key = "filament_max_volumetric_speed",
                   .unit = "mm3/s",
                   .min = 0,
                   .max = 1000,
                   .standard = "0",
                   .doc = "Bound on the extruded volume per second; 0: none",
                   .field = Bind<&ToolRow::max_volumetric_speed_mm3_s>(),
                   .orca = {{"filament_max_volumetric_speed"}}}),
      PerExtruder({.key = "pressure_advance",
                   .min = 0,
                   .max = 100,
                   .standard = "0",
                   .doc = "Pressure advance (linear advance) of the filament, in the unit of the "
                          "firmware; 0: left as it is",
                   .field = Bind<&ToolRow::pressure_advance>()}),
      Orca({"filament_type"},
           text("filament_type", "PLA", "Name of the material, for printer hosts",
                Bind<&ToolRow::filament_type>())),
      Orca({"filament_colour"},
           text("filament_colour", "#29B2B2", "Colour of the filament, for printer hosts",
                Bind<&ToolRow::filament_colour>())),
      Orca({"filament_settings_id"},
           text("filament_settings_id", "", "Name of the filament's profile, for printer hosts",
                Bind<&ToolRow::filament_settings_id>())),
  };
}

}  // namespace

std::vector<SettingSpec> FilamentSettings() {
  std::vector<SettingSpec> settings = Material();
  for (SettingSpec& spec : Temperatures()) settings.push_back(std::move(spec));
  for (SettingSpec& spec : Cooling()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
