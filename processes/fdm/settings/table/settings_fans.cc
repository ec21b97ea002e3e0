#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

/// Returns a fan speed of the filament; -1 requests the usual speed.
SettingSpec OwnFan(std::string_view key, std::string_view doc, Field field, OrcaName orca) {
  return {.key = key,
          .kind = Kind::kInteger,
          .unit = "%",
          .min = -1,
          .max = 100,
          .standard = "-1",
          .doc = doc,
          .list = List::kPerExtruder,
          .field = field,
          .orca = {orca}};
}

std::vector<SettingSpec> FansOfLines() {
  return {
      OwnFan("internal_bridge_fan_speed",
             "Fan speed at bridges over sparse infill; -1: bridge_fan_speed. The fan stays off in "
             "the layers of disable_fan_first_layers",
             Bind<&ToolRow::cooling, &CoolingOptions::internal_bridge_fan_percent>(),
             {"internal_bridge_fan_speed"}),
      OwnFan("ironing_fan_speed",
             "Fan speed at ironing; -1: as at other lines. The fan stays off in the layers of "
             "disable_fan_first_layers",
             Bind<&ToolRow::cooling, &CoolingOptions::ironing_fan_percent>(),
             {"ironing_fan_speed"}),
      OwnFan("first_layer_fan_speed",
             "Fan speed of all lines in the first layer, if disable_fan_first_layers is 0; "
             "full_fan_speed_layer rises from it. -1: as in other layers",
             Bind<&ToolRow::cooling, &CoolingOptions::first_layer_fan_percent>(),
             {"initial_layer_fan_speed"}),
  };
}

std::vector<SettingSpec> FanOfMachine() {
  return {
      {.key = "fan_kickstart",
       .unit = "s",
       .min = 0,
       .max = 60,
       .standard = "0",
       .doc =
           "Time for which the fan first runs at full speed when its speed rises from 0 to 100 %. "
           "A smaller rise gets its share of this time, and a rise of 10 % or less no such time",
       .field = Bind<&MachineRow::motion, &MachineMotion::fan_kickstart_s>(),
       .orca = {{"fan_kickstart"}}},
      {.key = "part_cooling_fan_min_pwm",
       .kind = Kind::kInteger,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "0",
       .doc = "Smallest speed of the part cooling fan while it runs; smaller speeds, except 0, are "
              "raised to this speed",
       .field = Bind<&MachineRow::motion, &MachineMotion::fan_least_percent>(),
       .orca = {{"part_cooling_fan_min_pwm"}}},
  };
}

std::vector<SettingSpec> AdaptiveAdvanceSettings() {
  return {
      {.key = "adaptive_pressure_advance",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Set the pressure advance for each feature by its flow and its acceleration "
              "(adaptive_pressure_advance_model) instead of once by pressure_advance",
       .list = List::kPerExtruder,
       .field = Bind<&ToolRow::advance, &AdaptiveAdvance::on>()},
      {.key = "adaptive_pressure_advance_model",
       .kind = Kind::kAdvancePoints,
       .standard = "",
       .doc =
           "Measured pressure advance by flow and acceleration; values in between are "
           "interpolated. Accelerations with only one point are ignored. Empty: pressure_advance",
       .field = Bind<&ToolRow::advance, &AdaptiveAdvance::model>(),
       .needs = {&needs::kAdaptiveAdvance}},
      {.key = "adaptive_pressure_advance_overhangs",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Set the pressure advance also where the flow changes within a feature, as at "
              "overhangs",
       .list = List::kPerExtruder,
       .field = Bind<&ToolRow::advance, &AdaptiveAdvance::within_features>(),
       .orca = {{"adaptive_pressure_advance_overhangs"}},
       .needs = {&needs::kAdaptiveAdvance}},
      {.key = "adaptive_pressure_advance_bridges",
       .min = 0,
       .max = 100,
       .standard = "0",
       .doc = "Pressure advance of bridges and of walls over air; 0: by the model",
       .list = List::kPerExtruder,
       .field = Bind<&ToolRow::advance, &AdaptiveAdvance::bridges>(),
       .orca = {{"adaptive_pressure_advance_bridges"}},
       .needs = {&needs::kAdaptiveAdvance}},
  };
}

}  // namespace

std::vector<SettingSpec> FanSettings() {
  std::vector<SettingSpec> settings = FansOfLines();
  for (auto part : {FanOfMachine(), AdaptiveAdvanceSettings()})
    for (SettingSpec& spec : part) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
