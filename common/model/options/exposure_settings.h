#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/model/options/exposure_options.h"

namespace slicefarm {

/// What the exposure of a job is made with.
struct ExposureSettings {
  std::vector<ExposureOptions> regions = {{}};  ///< by region: Region names the row
  ExposureOutput output;

  friend bool operator==(const ExposureSettings&, const ExposureSettings&) = default;
};

/// How many of an object's own layers on each side a layer's result depends on.
inline int32_t HaloLayers(const ExposureSettings& settings) {
  int32_t halo = 0;
  for (const ExposureOptions& region : settings.regions) halo = std::max(halo, region.Halo());
  return halo;
}

}  // namespace slicefarm
