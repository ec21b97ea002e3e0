#include "common/model/settings.h"

#include <algorithm>

namespace slicefarm {

namespace {

int32_t LaserHaloLayers(const JobSettings& settings) {
  int32_t halo = 0;
  for (const ExposureOptions& region : settings.exposure.regions)
    halo = std::max(halo, region.Halo());
  return halo;
}

}  // namespace

int32_t HaloLayers(const JobSettings& settings) {
  if (settings.process == Process::kLaser) return LaserHaloLayers(settings);
  int32_t halo = BeadingHaloLayers(settings);
  for (const InfillOptions& infill : settings.infill)
    halo = std::max({halo, infill.top_solid_layers, infill.bottom_solid_layers,
                     infill.field_halo_layers});
  if (LooksBelow(settings.motion)) halo = std::max(halo, 1);
  return halo;
}

int32_t BeadingHaloLayers(const JobSettings& settings) {
  const bool arachne = std::ranges::any_of(settings.beading, [](const BeadingOptions& beading) {
    return beading.generator == WallGenerator::kArachne;
  });
  return arachne ? kBeadingHaloLayers : 0;
}

}  // namespace slicefarm
