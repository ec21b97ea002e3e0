#pragma once

#include <vector>

#include "common/model/options/exposure_options.h"

namespace slicefarm {

/// What the exposure of a job is made with.
struct ExposureSettings {
  std::vector<ExposureOptions> regions = {{}};  ///< by region, as in JobSettings
  ExposureOutput output;

  friend bool operator==(const ExposureSettings&, const ExposureSettings&) = default;
};

}  // namespace slicefarm
