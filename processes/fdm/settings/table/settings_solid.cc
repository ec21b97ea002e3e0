#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

template <auto kMember, Scale kScale = Scale::kSame>
Field Solid() {
  return Bind<kScale, &RegionRow::infill, &InfillOptions::solid, kMember>();
}

SettingSpec SurfaceDensity(std::string_view key, double least, std::string_view doc, Field field) {
  return {.key = key,
          .kind = Kind::kPercent,
          .unit = "%",
          .min = least,
          .max = 100,
          .standard = "100%",
          .doc = doc,
          .field = field,
          .orca = {{key, OrcaValue::kPercent}}};
}

}  // namespace

std::vector<SettingSpec> SolidSettings() {
  const auto filter = [](SparseBridgeFilter value) { return static_cast<int>(value); };
  return {
      SurfaceDensity("top_surface_density", 0,
                     "Share of the area of top surfaces that their lines cover; smaller: gaps "
                     "between the lines. 0%: only walls",
                     Solid<&SolidOptions::top_density, Scale::kPercent>()),
      SurfaceDensity("bottom_surface_density", 10,
                     "Share of the area of bottom surfaces, except bridges, that their lines "
                     "cover; smaller: gaps between the lines",
                     Solid<&SolidOptions::bottom_density, Scale::kPercent>()),
      {.key = "extra_solid_infills",
       .kind = Kind::kSolidLayers,
       .standard = "",
       .doc = "Layers of the object that have only solid infill, counted from 1. 5: every 5th "
              "layer. 5#2: two consecutive layers, beginning with every 5th layer. 1,7#2,9: layers "
              "1, 7, 8 and 9. Empty: none",
       .field = Solid<&SolidOptions::extra_layers>(),
       .orca = {{"extra_solid_infills", OrcaValue::kWhole}}},
      {.key = "elefant_foot_layers_density",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 50,
       .max = 100,
       .standard = "100%",
       .doc = "Density of solid infill inside the object in the second layer on the bed, so that "
              "it presses less plastic outwards. It rises to 100% after "
              "elefant_foot_compensation_layers layers",
       .field = Solid<&SolidOptions::foot_density, Scale::kPercent>(),
       .own_scope = Scope::kObject,
       .orca = {{"elefant_foot_layers_density", OrcaValue::kPercent}}},
      {.key = "detect_narrow_internal_solid_infill",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc =
           "Print loops instead of lines in parts of the solid infill inside the object that are "
           "narrower than 4 mm; parts with longer lines keep them. OrcaSlicer's default: 1",
       .field = Solid<&SolidOptions::narrow_loops>(),
       .orca = {{"detect_narrow_internal_solid_infill"}}},
      {.key = "dont_filter_internal_bridges",
       .kind = Kind::kChoice,
       .standard = "disabled",
       .doc = "Skins over sparse infill that become bridges. disabled: skins wider than the "
              "distance of the lines below. limited: skins wider than half of this distance. "
              "nofilter: all skins",
       .choices = {{"disabled", filter(SparseBridgeFilter::kWide)},
                   {"limited", filter(SparseBridgeFilter::kMedium)},
                   {"nofilter", filter(SparseBridgeFilter::kAll)}},
       .field = Solid<&SolidOptions::bridges>(),
       .orca = {{"dont_filter_internal_bridges"}}},
  };
}

}  // namespace slicefarm::config::fdm
