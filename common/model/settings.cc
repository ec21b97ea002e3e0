#include "common/model/settings.h"

#include <algorithm>

namespace slicefarm {

int32_t HaloLayers(const JobSettings& settings) {
  return std::max(settings.infill.top_solid_layers, settings.infill.bottom_solid_layers);
}

int32_t BeadingHaloLayers(const JobSettings& /*settings*/) { return 0; }

}  // namespace slicefarm
