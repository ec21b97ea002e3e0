#include "common/model/options/fdm_settings.h"

#include <algorithm>

namespace slicefarm {

namespace {

bool NeedsPlan(const InfillOptions& infill) {
  return infill.choose_pattern || InfoOf(infill.pattern).planned || infill.every_layers > 1 ||
         infill.only_where_needed;
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
                     .walls_nm = infill.walls_nm,
                     .top_solid_layers = infill.top_solid_layers,
                     .bottom_solid_layers = infill.bottom_solid_layers,
                     .top_spare = infill.top_spare,
                     .bottom_spare = infill.bottom_spare,
                     .interface_shells = infill.interface_shells,
                     .every_layers = infill.every_layers,
                     .only_where_needed = infill.only_where_needed});
  }
  return plans;
}

int32_t HaloLayers(const FdmSettings& settings) {
  int32_t halo = BeadingHaloLayers(settings);
  for (const InfillOptions& infill : settings.infill)
    halo = std::max({halo, infill.top_solid_layers,
                     infill.bottom_solid_layers + (BridgesSparse(infill) ? 1 : 0),
                     infill.field_halo_layers, infill.over_bridges ? kOverBridgeHaloLayers : 0});
  const bool winds_up = std::ranges::any_of(
      settings.planning.objects,
      [](const ObjectPlanOptions& object) { return object.spiral.width_nm > 0; });
  if (LooksBelow(settings.motion) || winds_up) halo = std::max(halo, 1);
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
