#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

template <Feature kFeature>
Field FlowOf() {
  return Bind<&RegionRow::motion, &RegionMotion::flow, static_cast<int>(kFeature)>();
}

SettingSpec Flow(std::string_view key, std::string_view doc, Field field) {
  return {.key = key, .min = 0.01, .max = 2, .standard = "1", .doc = doc, .field = field};
}

}  // namespace

// The names in OrcaSlicer are in orca_pairs.cc, because they depend on set_other_flow_ratios.
std::vector<SettingSpec> FlowSettings() {
  return {
      Flow("first_layer_flow_ratio",
           "Factor for the flow of all lines in the first layer, multiplied by the other flow "
           "ratios; 1: as in other layers",
           Bind<&RegionRow::motion, &RegionMotion::first_layer_flow>()),
      Flow("external_perimeter_flow_ratio",
           "Factor for the flow of outer walls; 1: the flow that fills their extrusion width",
           FlowOf<Feature::kExternalPerimeter>()),
      Flow("perimeter_flow_ratio",
           "Factor for the flow of inner walls; 1: the flow that fills their extrusion width",
           FlowOf<Feature::kPerimeter>()),
      Flow("overhang_flow_ratio",
           "Factor for the flow of walls over air, multiplied by bridge_flow_ratio; 1: "
           "bridge_flow_ratio alone",
           FlowOf<Feature::kOverhangPerimeter>()),
      Flow("infill_flow_ratio",
           "Factor for the flow of sparse infill lines; 1: the flow that fills "
           "infill_extrusion_width",
           FlowOf<Feature::kInternalInfill>()),
      Flow("solid_infill_flow_ratio",
           "Factor for the flow of all solid infill except top surfaces, multiplied by "
           "bottom_solid_infill_flow_ratio on bottom surfaces; 1: no change",
           FlowOf<Feature::kSolidInfill>()),
      Flow("gap_fill_flow_ratio",
           "Factor for the flow of gap fill; 1: the flow that fills the width of the gap",
           FlowOf<Feature::kGapFill>()),
      InScope(Scope::kObject, Flow("support_material_flow_ratio",
                                   "Factor for the flow of supports and rafts, except support "
                                   "interfaces; 1: the flow that fills their extrusion width",
                                   FlowOf<Feature::kSupport>())),
      InScope(Scope::kObject, Flow("support_material_interface_flow_ratio",
                                   "Factor for the flow of support interfaces; 1: the flow that "
                                   "fills their extrusion width",
                                   FlowOf<Feature::kSupportInterface>())),
  };
}

}  // namespace slicefarm::config::fdm
