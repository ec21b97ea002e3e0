#include "processes/fdm/model/fdm_settings.h"

#include <algorithm>

namespace slicefarm {

namespace {

/// Returns one member of each region's row.
template <typename Member>
std::vector<Member> Column(const FdmSettings& settings, Member RegionRow::*member) {
  std::vector<Member> column;
  column.reserve(settings.regions.size());
  for (const RegionRow& region : settings.regions) column.push_back(region.*member);
  return column;
}

}  // namespace

std::vector<BeadingOptions> BeadingOf(const FdmSettings& settings) {
  return Column(settings, &RegionRow::walls);
}

std::vector<InfillOptions> InfillOf(const FdmSettings& settings) {
  return Column(settings, &RegionRow::infill);
}

PlanningOptions PlanningOf(const FdmSettings& settings) {
  PlanningOptions options{settings.machine.plan, settings.objects, {}};
  const bool needs_plan = std::ranges::any_of(
      settings.regions, [](const RegionRow& region) { return NeedsPlan(region.infill); });
  if (needs_plan) options.infill = InfillOf(settings);
  return options;
}

OrderingOptions OrderingOf(const FdmSettings& settings) {
  return {settings.machine.order, Column(settings, &RegionRow::order)};
}

MotionOptions MotionOf(const FdmSettings& settings) {
  return {settings.machine.motion, settings.tools, Column(settings, &RegionRow::motion)};
}

MotionOptions MotionOf(const FdmRows& rows) {
  return {rows.machine.motion, {rows.tool}, {rows.region.motion}};
}

int32_t HaloLayers(const FdmSettings& settings) {
  int32_t halo = BeadingHaloLayers(settings);
  for (const RegionRow& region : settings.regions) {
    const InfillOptions& infill = region.infill;
    const bool over_bridges = infill.over_bridges || DoublesExternal(infill.bridges.extra);
    const int32_t sparse_bridges = !BridgesSparse(infill)                  ? 0
                                   : DoublesInternal(infill.bridges.extra) ? 2
                                                                           : 1;
    halo = std::max({halo, infill.top_solid_layers, infill.bottom_solid_layers + sparse_bridges,
                     infill.field_halo_layers, over_bridges ? kOverBridgeHaloLayers : 0});
  }
  const bool winds_up = std::ranges::any_of(
      settings.objects, [](const ObjectRow& object) { return object.spiral.width_nm > 0; });
  if (LooksBelow(MotionOf(settings)) || winds_up) halo = std::max(halo, 1);
  return halo;
}

int32_t BeadingHaloLayers(const FdmSettings& settings) {
  int32_t halo = 0;
  for (const RegionRow& region : settings.regions) {
    if (region.walls.generator == WallGenerator::kArachne) return kBeadingHaloLayers;
    if (region.walls.one_on_top == OneWallOnTop::kSurfaces || region.walls.extra_perimeters)
      halo = 1;
  }
  return halo;
}

}  // namespace slicefarm
