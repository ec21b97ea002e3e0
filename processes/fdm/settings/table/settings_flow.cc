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
           "Flow of the first layer, in addition to the other ratios; 1: as in other layers",
           Bind<&RegionRow::motion, &RegionMotion::first_layer_flow>()),
      Flow("external_perimeter_flow_ratio",
           "Flow of outer walls relative to their width; 1: the same",
           FlowOf<Feature::kExternalPerimeter>()),
      Flow("perimeter_flow_ratio", "Flow of inner walls relative to their width; 1: the same",
           FlowOf<Feature::kPerimeter>()),
      Flow("overhang_flow_ratio",
           "Flow of walls over air, in addition to bridge_flow_ratio; 1: the same",
           FlowOf<Feature::kOverhangPerimeter>()),
      Flow("infill_flow_ratio", "Flow of sparse infill relative to fill_density; 1: the same",
           FlowOf<Feature::kInternalInfill>()),
      Flow("solid_infill_flow_ratio",
           "Flow of solid infill that is no top surface, in addition to "
           "bottom_solid_infill_flow_ratio; 1: the same",
           FlowOf<Feature::kSolidInfill>()),
      Flow("gap_fill_flow_ratio", "Flow of gap fill relative to the gap's width; 1: the same",
           FlowOf<Feature::kGapFill>()),
      InScope(Scope::kObject,
              Flow("support_material_flow_ratio",
                   "Flow of supports and rafts relative to their width; 1: the same",
                   FlowOf<Feature::kSupport>())),
      InScope(Scope::kObject,
              Flow("support_material_interface_flow_ratio",
                   "Flow of support interfaces relative to their width; 1: the same",
                   FlowOf<Feature::kSupportInterface>())),
  };
}

}  // namespace slicefarm::config::fdm
