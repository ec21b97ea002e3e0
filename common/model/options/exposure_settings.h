#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/model/options/exposure_options.h"

namespace slicefarm {

/// One resolved set of settings for exposure: a row of each scope.
struct ExposureRows {
  ExposureOptions region;
  ExposureOutput output;

  friend bool operator==(const ExposureRows&, const ExposureRows&) = default;
};

/// Settings of a plate for exposure. Region names rows of `regions`.
struct ExposureSettings {
  std::vector<ExposureOptions> regions = {{}};
  ExposureOutput output;

  friend bool operator==(const ExposureSettings&, const ExposureSettings&) = default;
};

/// Returns how many of an object's own layers on each side a layer's result depends on.
inline int32_t HaloLayers(const ExposureSettings& settings) {
  int32_t halo = 0;
  for (const ExposureOptions& region : settings.regions) halo = std::max(halo, region.Halo());
  return halo;
}

}  // namespace slicefarm
