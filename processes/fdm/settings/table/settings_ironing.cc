#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {

std::vector<SettingSpec> IroningSettings() {
  return {
      {.key = "ironing",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Smooth surfaces with a second pass of the hot nozzle at low flow",
       .field = Bind<&RegionRow::infill, &InfillOptions::ironing, &IroningOptions::enabled>(),
       .orca = {{"ironing_type", OrcaValue::kChoice}}},
      {.key = "ironing_type",
       .kind = Kind::kChoice,
       .standard = "top",
       .doc = "Surfaces that are ironed. top: all top surfaces. topmost: top surfaces of the last "
              "layer. solid: all solid infill",
       .choices = {{"top", static_cast<int>(IroningType::kTop)},
                   {"topmost", static_cast<int>(IroningType::kTopmost)},
                   {"solid", static_cast<int>(IroningType::kSolid)}},
       .field = Bind<&RegionRow::infill, &InfillOptions::ironing, &IroningOptions::type>(),
       .orca = {{"ironing_type", OrcaValue::kChoice}},
       .needs = {&needs::kIroning}},
      {.key = "ironing_flowrate",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "15%",
       .doc = "Flow of ironing relative to the flow that would fill the layer",
       .field = Bind<Scale::kPercent, &RegionRow::infill, &InfillOptions::ironing,
                     &IroningOptions::flow>(),
       .orca = {{"ironing_flow", OrcaValue::kPercent}},
       .needs = {&needs::kIroning}},
      {.key = "ironing_spacing",
       .unit = "mm",
       .min = 0.01,
       .max = 10,
       .standard = "0.1",
       .doc = "Distance between neighbouring ironing lines",
       .field = Bind<&RegionRow::infill, &InfillOptions::ironing, &IroningOptions::spacing_nm>(),
       .orca = {{"ironing_spacing"}},
       .needs = {&needs::kIroning}},
      {.key = "ironing_inset",
       .unit = "mm",
       .min = 0,
       .max = 10,
       .standard = "0",
       .doc = "Distance of ironing from the edges of the part; 0: half of the nozzle diameter",
       .field = Bind<&RegionRow::infill, &InfillOptions::ironing, &IroningOptions::inset_nm>(),
       .orca = {{"ironing_inset"}},
       .needs = {&needs::kIroning}},
      {.key = "ironing_pattern",
       .kind = Kind::kChoice,
       .standard = "rectilinear",
       .doc = "Pattern of ironing lines. rectilinear: straight lines. concentric: lines along the "
              "edges",
       .choices = {{"rectilinear", 0}, {"concentric", 1}},
       .field = Bind<&RegionRow::infill, &InfillOptions::ironing, &IroningOptions::concentric>(),
       .orca = {{"ironing_pattern", OrcaValue::kChoice}},
       .needs = {&needs::kIroning}},
      {.key = "ironing_angle",
       .unit = "degrees",
       .min = -1,
       .max = 360,
       .standard = "0",
       .doc =
           "Angle between the ironing lines and the lines of the top surface; with "
           "ironing_angle_fixed: angle between the ironing lines and the x axis. -1, the default "
           "of older versions of OrcaSlicer: 0",
       .field = Bind<Scale::kDegrees, &RegionRow::infill, &InfillOptions::ironing,
                     &IroningOptions::angle_rad>(),
       .orca = {{"ironing_angle"}},
       .needs = {&needs::kStraightIroning, &needs::kIroning}},
      {.key = "ironing_angle_fixed",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Iron all layers in the direction ironing_angle. 0: the direction turns with the "
              "lines of the top surface from layer to layer",
       .field = Bind<&RegionRow::infill, &InfillOptions::ironing, &IroningOptions::fixed_angle>(),
       .orca = {{"ironing_angle_fixed"}},
       .needs = {&needs::kStraightIroning, &needs::kIroning}},
      {.key = "ironing_expansion",
       .unit = "mm",
       .min = -100,
       .max = 100,
       .standard = "0",
       .doc = "Distance by which ironing extends beyond the surface, over plastic that the next "
              "layer covers; negative: ironing ends before the surface's edge. ironing_inset from "
              "the part's edge remains. OrcaSlicer has the setting, but it has no effect there",
       .field = Bind<&RegionRow::infill, &InfillOptions::ironing, &IroningOptions::expansion_nm>(),
       .orca = {{"ironing_expansion"}},
       .needs = {&needs::kIroning}},
  };
}

std::vector<SettingSpec> SupportIroningSettings() {
  return {
      {.key = "support_ironing",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Iron the tops of support interfaces, so that the surface above becomes smoother. "
              "These interfaces are solid, regardless of support_material_interface_spacing",
       .field = Bind<&ObjectRow::support, &SupportOptions::ironing, &IroningOptions::enabled>(),
       .orca = {{"support_ironing"}},
       .needs = {&needs::kSupportInterfaces}},
      {.key = "support_ironing_flow",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "10%",
       .doc = "Flow of support_ironing relative to the flow that would fill the layer. OrcaSlicer "
              "takes it of the flow of an interface line, for any distance of the ironing lines: "
              "with lines 0.1 mm apart, that is four times as much plastic",
       .field = Bind<Scale::kPercent, &ObjectRow::support, &SupportOptions::ironing,
                     &IroningOptions::flow>(),
       .orca = {{"support_ironing_flow", OrcaValue::kPercent}},
       .needs = {&needs::kSupportIroning}},
      {.key = "support_ironing_spacing",
       .unit = "mm",
       .min = 0.01,
       .max = 10,
       .standard = "0.1",
       .doc = "Distance between neighbouring lines of support_ironing",
       .field = Bind<&ObjectRow::support, &SupportOptions::ironing, &IroningOptions::spacing_nm>(),
       .orca = {{"support_ironing_spacing"}},
       .needs = {&needs::kSupportIroning}},
      {.key = "support_ironing_pattern",
       .kind = Kind::kChoice,
       .standard = "rectilinear",
       .doc = "Pattern of support_ironing. rectilinear: straight lines. concentric: lines along "
              "the edges",
       .choices = {{"rectilinear", 0}, {"concentric", 1}},
       .field = Bind<&ObjectRow::support, &SupportOptions::ironing, &IroningOptions::concentric>(),
       .orca = {{"support_ironing_pattern", OrcaValue::kChoice}},
       .needs = {&needs::kSupportIroning}},
  };
}

}  // namespace slicefarm::config::fdm
