#include "common/model/options/fdm_settings.h"

#include <algorithm>

namespace slicefarm {

namespace {

bool NeedsPlan(const InfillOptions& infill) {
  return infill.choose_pattern || InfoOf(infill.pattern).planned || infill.every_layers > 1 ||
         infill.only_where_needed;
}

/// Of the walls of an island that has room for all of them.
Coord WallsOf(const BeadingOptions& beading) {
  if (beading.perimeters == 0) return 0;
  return beading.external_width_nm + (beading.perimeters - 1) * beading.inner_width_nm;
}

}  // namespace

std::vector<InfillPlanOptions> InfillPlansOf(const FdmSettings& settings) {
  std::vector<InfillPlanOptions> plans;
  if (std::ranges::none_of(settings.infill, NeedsPlan)) return plans;
  for (size_t row = 0; row < settings.infill.size(); ++row) {
    const InfillOptions& infill = settings.infill[row];
    plans.push_back({.pattern = infill.pattern,
                     .choose_pattern = infill.choose_pattern,
                     .goal = infill.goal,
                     .density = infill.density,
                     .angle_rad = infill.angle_rad,
                     .width_nm = infill.sparse_width_nm,
                     .walls_nm = WallsOf(settings.beading[row]),
                     .top_solid_layers = infill.top_solid_layers,
                     .bottom_solid_layers = infill.bottom_solid_layers,
                     .interface_shells = infill.interface_shells,
                     .every_layers = infill.every_layers,
                     .only_where_needed = infill.only_where_needed});
  }
  return plans;
}

int32_t HaloLayers(const FdmSettings& settings) {
  int32_t halo = BeadingHaloLayers(settings);
  for (const InfillOptions& infill : settings.infill)
    halo = std::max({halo, infill.top_solid_layers, infill.bottom_solid_layers,
                     infill.field_halo_layers, infill.over_bridges ? kOverBridgeHaloLayers : 0});
  if (LooksBelow(settings.motion)) halo = std::max(halo, 1);
  return halo;
}

int32_t BeadingHaloLayers(const FdmSettings& settings) {
  int32_t halo = 0;
  for (const BeadingOptions& beading : settings.beading) {
    if (beading.generator == WallGenerator::kArachne) return kBeadingHaloLayers;
    if (beading.one_on_top == OneWallOnTop::kSurfaces || beading.extra_perimeters) halo = 1;
  }
  return halo;
}

}  // namespace slicefarm
