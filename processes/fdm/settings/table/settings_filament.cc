#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

/// Returns the setting with another least value.
SettingSpec WithLeast(double least, SettingSpec spec) {
  spec.min = least;
  return spec;
}

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
           temperature(
               "temperature", "200", 600,
               "Nozzle temperature after the first layer; 0: no temperature command is written",
               Bind<&ToolRow::temperature_c>())),
      Orca(
          {"nozzle_temperature_initial_layer"},
          temperature("first_layer_temperature", "200", 600,
                      "Nozzle temperature of the first layer; 0: no temperature command is written",
                      Bind<&ToolRow::first_layer_temperature_c>())),
      temperature("bed_temperature", "0", 300,
                  "Bed temperature after the first layer; 0: no temperature command is written",
                  Bind<&ToolRow::bed_temperature_c>()),
      temperature("first_layer_bed_temperature", "0", 300,
                  "Bed temperature of the first layer; 0: no temperature command is written",
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
           flag("cooling", "1",
                "Print layers shorter than slowdown_below_layer_time more slowly, and set the fan "
                "speed by fan_below_layer_time. 0: no slower printing, and the fan speed does not "
                "depend on the layer time",
                Bind<&ToolRow::cooling, &CoolingOptions::enabled>())),
      Orca({"reduce_fan_stop_start_freq"},
           flag("fan_always_on", "0",
                "Keep the fan at min_fan_speed or faster in all layers after "
                "disable_fan_first_layers; 0: the fan is off in layers that take "
                "fan_below_layer_time or longer",
                Bind<&ToolRow::cooling, &CoolingOptions::fan_always_on>())),
      Orca({"fan_min_speed"},
           Needing({&needs::kFan},
                   whole("min_fan_speed", "%", 100, "35",
                         "Fan speed in layers that take slightly less than fan_below_layer_time; "
                         "with fan_always_on = 1, also in all longer layers",
                         Bind<&ToolRow::cooling, &CoolingOptions::min_fan_percent>()))),
      Orca({"fan_max_speed"},
           Needing({&needs::kCooling},
                   whole("max_fan_speed", "%", 100, "100",
                         "Fan speed in layers that take slowdown_below_layer_time or less; 100: "
                         "the fan's full speed",
                         Bind<&ToolRow::cooling, &CoolingOptions::max_fan_percent>()))),
      Orca({"overhang_fan_speed"},
           WithLeast(-1, whole("bridge_fan_speed", "%", 100, "100",
                               "Fan speed at bridges, and at outer walls that overhang as far as "
                               "overhang_fan_threshold says; only with enable_bridge_fan = 1. A "
                               "faster fan of the layer is kept. -1: the fan of the layer",
                               Bind<&ToolRow::cooling, &CoolingOptions::bridge_fan_percent>()))),
      PerExtruder(
          {.key = "overhang_fan_threshold",
           .kind = Kind::kPercent,
           .unit = "%",
           .min = 0,
           .max = 100,
           .standard = "100%",
           .doc = "Overhang from which an outer wall is cooled with bridge_fan_speed, as the share "
                  "of the wall's width that is not on the layer below. 0%: all outer walls. 100%: "
                  "only walls that are bridges",
           .field = Bind<Scale::kPercent, &ToolRow::cooling, &CoolingOptions::overhang_fan_share>(),
           .orca = {{"overhang_fan_threshold", OrcaValue::kPercent}}}),
      PerExtruder({.key = "support_material_interface_fan_speed",
                   .kind = Kind::kInteger,
                   .unit = "%",
                   .min = -1,
                   .max = 100,
                   .standard = "-1",
                   .doc = "Fan speed at support interfaces; -1: the fan speed of the layer. The "
                          "fan stays off in the layers of disable_fan_first_layers",
                   .field = Bind<&ToolRow::cooling, &CoolingOptions::interface_fan_percent>(),
                   .orca = {{"support_material_interface_fan_speed"}}}),
      Orca({"enable_overhang_bridge_fan"},
           flag("enable_bridge_fan", "1",
                "Run the fan at bridge_fan_speed over bridges and overhangs; 0: bridges and "
                "overhangs get the fan speed of the layer",
                Bind<&ToolRow::cooling, &CoolingOptions::bridge_fan>())),
      Orca({"dont_slow_down_outer_wall"},
           flag("dont_slow_down_outer_wall", "0",
                "Print outer walls at full speed also in layers shorter than "
                "slowdown_below_layer_time, so that their surface looks even; the other lines are "
                "slowed down more. 0: outer walls are slowed down too",
                Bind<&ToolRow::cooling, &CoolingOptions::keep_outer_walls>())),
      Orca({"close_fan_the_first_x_layers"},
           whole("disable_fan_first_layers", "layers", 1000, "3",
                 "Number of layers, counted from the bed, that are printed with the fan off; 0: no "
                 "layers",
                 Bind<&ToolRow::cooling, &CoolingOptions::disable_fan_first_layers>())),
      Orca({"full_fan_speed_layer"},
           whole("full_fan_speed_layer", "layers", 100'000, "0",
                 "First layer in which the fan has the full speed that the other fan settings "
                 "require. From disable_fan_first_layers up to this layer, the speed rises evenly. "
                 "0: full speed right after disable_fan_first_layers",
                 Bind<&ToolRow::cooling, &CoolingOptions::full_fan_speed_layer>())),
      flag("enable_dynamic_fan_speeds", "0",
           "Set the fan speed at overhanging walls by the settings overhang_fan_speed_0 to "
           "overhang_fan_speed_3, interpolated between them; 0: these walls get the fan speed of "
           "the layer",
           Bind<&ToolRow::cooling, &CoolingOptions::dynamic_fan>()),
      OverhangFan<0>("overhang_fan_speed_0",
                     "Fan speed at walls that overhang with their full width, with "
                     "enable_dynamic_fan_speeds = 1; a faster fan of the layer is kept"),
      OverhangFan<1>("overhang_fan_speed_1",
                     "Fan speed at walls with 25 % of their width on the layer below, with "
                     "enable_dynamic_fan_speeds = 1; a faster fan of the layer is kept"),
      OverhangFan<2>("overhang_fan_speed_2",
                     "Fan speed at walls with 50 % of their width on the layer below, with "
                     "enable_dynamic_fan_speeds = 1; a faster fan of the layer is kept"),
      OverhangFan<3>("overhang_fan_speed_3",
                     "Fan speed at walls with 75 % of their width on the layer below, with "
                     "enable_dynamic_fan_speeds = 1; a faster fan of the layer is kept"),
      Orca({"fan_cooling_layer_time"},
           Needing({&needs::kCooling},
                   whole("fan_below_layer_time", "s", 1000, "60",
                         "Layer time below which the fan runs. The fan speed rises from "
                         "min_fan_speed at this time to max_fan_speed at slowdown_below_layer_time",
                         Bind<&ToolRow::cooling, &CoolingOptions::fan_below_layer_time_s>()))),
      Orca({"slow_down_layer_time"},
           Needing({&needs::kCooling},
                   whole("slowdown_below_layer_time", "s", 1000, "5",
                         "Shortest time that a layer may take; lines of shorter layers are slowed "
                         "down until the layer takes this time or the lines reach min_print_speed. "
                         "0: no lines are slowed down",
                         Bind<&ToolRow::cooling, &CoolingOptions::slowdown_below_layer_time_s>()))),
      PerExtruder(
          {.key = "cooling_slowdown_logic",
           .kind = Kind::kChoice,
           .standard = "uniform_cooling",
           .doc = "Lines that are slowed down in layers shorter than slowdown_below_layer_time. "
                  "uniform_cooling: all lines alike. consistent_surface: first all lines except "
                  "the two outermost walls. These walls are slowed down only if the layer is still "
                  "too short, so that the surface looks even",
           .choices = {{"uniform_cooling", 0}, {"consistent_surface", 1}},
           .field = Bind<&ToolRow::cooling, &CoolingOptions::consistent_surface>()}),
      PerExtruder(
          {.key = "cooling_perimeter_transition_distance",
           .unit = "mm",
           .min = 0,
           .max = 1000,
           .standard = "0",
           .doc = "Length of the path before an outer wall that is slowed down together with the "
                  "wall, so that the flow is steady where the wall begins. 0: only the walls",
           .field = Bind<&ToolRow::cooling, &CoolingOptions::transition_mm>(),
           .needs = {&needs::kConsistentSurface}}),
      PerExtruder({.key = "min_print_speed",
                   .unit = "mm/s",
                   .min = 0,
                   .max = 1000,
                   .standard = "10",
                   .doc = "Lowest speed to which lines are slowed down in layers shorter than "
                          "slowdown_below_layer_time",
                   .field = Bind<&ToolRow::cooling, &CoolingOptions::min_print_speed_mm_s>(),
                   .orca = {{"slow_down_min_speed"}},
                   .needs = {&needs::kCooling}}),
  };
}

std::vector<SettingSpec> Material() {
  const auto text = [](std::string_view key, std::string_view standard, std::string_view doc,
                       Field field) {
    return PerExtruder(
        {.key = key, .kind = Kind::kText, .standard = standard, .doc = doc, .field = field});
  };
  return {
      PerExtruder(
          {.key = "chamber_temperature",
           .kind = Kind::kInteger,
           .unit = "C",
           .min = 0,
           .max = 1000,
           .standard = "0",
           .doc =
               "Chamber temperature during the print (M141); 0: no temperature command is written",
           .field = Bind<&ToolRow::chamber_temperature_c>(),
           .orca = {{"chamber_temperature"}}}),
      {.key = "activate_chamber_temp_control",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Heat the chamber to chamber_temperature (M141, M191); 0: only custom G-code uses "
              "the chamber temperatures",
       .field = Bind<&MachineRow::motion, &MachineMotion::heats_chamber>()},
      PerExtruder({.key = "chamber_minimal_temperature",
                   .kind = Kind::kInteger,
                   .unit = "C",
                   .min = 0,
                   .max = 1000,
                   .standard = "0",
                   .doc = "Chamber temperature that must be reached before the print starts "
                          "(M191); 0: the print does not wait for the chamber",
                   .field = Bind<&ToolRow::chamber_least_c>(),
                   .orca = {{"chamber_minimal_temperature"}}}),
      PerExtruder({.key = "filament_infill_max_speed",
                   .unit = "mm/s",
                   .min = 0,
                   .max = 10'000,
                   .standard = "0",
                   .doc = "Highest speed of this filament in sparse infill; 0: no limit"}),
      PerExtruder({.key = "filament_infill_max_crossing_speed",
                   .unit = "mm/s",
                   .min = 0,
                   .max = 10'000,
                   .standard = "0",
                   .doc = "Highest speed of this filament in sparse infill patterns with lines "
                          "that cross within a layer, such as grid; 0: no limit"}),
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
                   .doc = "Factor for the flow of all extrusion; 1: the flow that the extrusion "
                          "widths and layer heights require",
                   .field = Bind<&ToolRow::extrusion_multiplier>(),
                   .orca = {{"filament_flow_ratio"}}}),
      Orca({"filament_shrink", OrcaValue::kRest},
           Shrinkage("filament_shrinkage_compensation_xy",
                     "Shrinkage of the filament in x and y; parts are printed larger to make up "
                     "for it. 1%: an uncompensated part of 100 mm measures 99 mm")),
      Orca({"filament_shrinkage_compensation_z", OrcaValue::kRest},
           Shrinkage("filament_shrinkage_compensation_z",
                     "Shrinkage of the filament in z; parts are printed taller to make up for it. "
                     "1%: an uncompensated part 100 mm high measures 99 mm")),
      PerExtruder({.key = "filament_density",
                   .unit = "g/cm3",
                   .min = 0,
                   .max = 30,
                   .standard = "1.24",
                   .doc = "Density of the filament, for the mass in the report",
                   .field = Bind<&ToolRow::filament_density_g_cm3>(),
                   .orca = {{"filament_density"}}}),
      PerExtruder({.key = "filament_cost",
                   .unit = "money/kg",
                   .min = 0,
                   .max = 1e6,
                   .standard = "0",
                   .doc = "Cost of the filament, for the cost in the report",
                   .field = Bind<&ToolRow::filament_cost_per_kg>(),
                   .orca = {{"filament_cost"}}}),
      PerExtruder({.key = "filament_max_volumetric_speed",
                   .unit = "mm3/s",
                   .min = 0,
                   .max = 1000,
                   .standard = "0",
                   .doc = "Highest volume of this filament that is extruded per second; faster "
                          "lines are slowed down. 0: no limit",
                   .field = Bind<&ToolRow::max_volumetric_speed_mm3_s>(),
                   .orca = {{"filament_max_volumetric_speed"}}}),
      PerExtruder({.key = "filament_adaptive_volumetric_speed",
                   .kind = Kind::kFlag,
                   .standard = "0",
                   .doc =
                       "Limit the volume per second by the height and width of the line as well, "
                       "by volumetric_speed_coefficients",
                   .orca = {{"filament_adaptive_volumetric_speed"}},
                   .needs = {&needs::kFlowFit}}),
      PerExtruder({.key = "volumetric_speed_coefficients",
                   .kind = Kind::kText,
                   .standard = "",
                   .doc =
                       "Six factors, separated by spaces, of h^2, w^2, h w, h, w and 1: their sum "
                       "is the highest volume per second (mm3/s) of a line of height h and width "
                       "w in mm. Empty, all 0 or a sum below 0: no limit",
                   .field = Bind<&ToolRow::flow_fit>(),
                   .orca = {{"volumetric_speed_coefficients"}},
                   .needs = {&needs::kAdaptiveFlow}}),
      PerExtruder({.key = "pressure_advance",
                   .min = 0,
                   .max = 100,
                   .standard = "0",
                   .doc = "Pressure advance (linear advance) of the filament, in the unit of the "
                          "firmware; 0: no pressure advance command is written",
                   .field = Bind<&ToolRow::pressure_advance>()}),
      Orca({"filament_type"},
           text("filament_type", "PLA", "Name of the material, shown by printer hosts",
                Bind<&ToolRow::filament_type>())),
      Orca({"filament_colour"},
           text("filament_colour", "#29B2B2", "Colour of the filament, shown by printer hosts",
                Bind<&ToolRow::filament_colour>())),
      Orca({"filament_settings_id"},
           text("filament_settings_id", "", "Name of the filament profile, shown by printer hosts",
                Bind<&ToolRow::filament_settings_id>())),
      PerExtruder({.key = "filament_id",
                   .kind = Kind::kText,
                   .standard = "",
                   .doc = "Id of the filament at its maker, such as GFA00, by which printers of "
                          "Bambu Lab find its spool; .gcode.3mf files contain this id",
                   .orca = {{"filament_id"}, {"filament_ids"}}}),
  };
}

}  // namespace

std::vector<SettingSpec> FilamentSettings() {
  std::vector<SettingSpec> settings = Material();
  for (SettingSpec& spec : Temperatures()) settings.push_back(std::move(spec));
  for (auto part : {Cooling(), FanSettings()})
    for (SettingSpec& spec : part) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
