#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {

std::vector<SettingSpec> ContourSettings() {
  return {
      {.key = "zaa_enabled",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Let top surfaces, ironing and walls follow the slope of the part within each layer "
              "(Z contouring): gentle slopes have no steps. Walls are then printed from the "
              "outside. The nozzle never rises above the layer, and never dips more than 0.05 mm "
              "below plastic beside it, so slopes above 6 degrees may keep small steps",
       .field = Bind<&ObjectSlicingOptions::contour, &SurfaceContour::on>(),
       .orca = {{"zaa_enabled"}}},
      {.key = "zaa_min_z",
       .unit = "mm",
       .min = 0.01,
       .max = 5,
       .standard = "0.05",
       .doc = "Least height of a bead that follows a slope; smaller: smoother slopes. At most half "
              "of the layer's height counts",
       .field = Bind<&ObjectSlicingOptions::contour, &SurfaceContour::least_nm>(),
       .orca = {{"zaa_min_z"}},
       .needs = {&needs::kContour}},
      {.key = "zaa_minimize_perimeter_height",
       .unit = "degrees",
       .min = 0,
       .max = 90,
       .standard = "35",
       .doc = "Slope, measured from horizontal, above which a wall's outer edge instead of its "
              "middle lies at the surface, so that the wall does not stand out of the part; 0: on "
              "no slope",
       .field = Bind<Scale::kDegrees, &RegionRow::motion, &RegionMotion::contour_edge_slope_rad>(),
       .orca = {{"zaa_minimize_perimeter_height"}},
       .needs = {&needs::kContour}},
      {.key = "zaa_dont_alternate_fill_direction",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Keep the direction of infill lines from layer to layer, which makes contoured "
              "surfaces look even; 0: lines turn by 90 degrees in every layer",
       .field = Bind<&RegionRow::infill, &InfillOptions::same_direction>(),
       .orca = {{"zaa_dont_alternate_fill_direction"}},
       .needs = {&needs::kContour}},
  };
}

}  // namespace slicefarm::config::fdm
