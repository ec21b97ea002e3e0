#include "common/model/settings.h"

#include <algorithm>

namespace slicefarm {

int32_t HaloLayers(const JobSettings& settings) {
  return std::max({settings.infill.top_solid_layers, settings.infill.bottom_solid_layers,
                   BeadingHaloLayers(settings)});
}

int32_t BeadingHaloLayers(const JobSettings& settings) {
  return settings.beading.generator == WallGenerator::kArachne ? kBeadingHaloLayers : 0;
}

}  // namespace slicefarm
