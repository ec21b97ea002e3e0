#pragma once

#include <vector>

#include "common/model/layers/job_plan.h"
#include "processes/laser/model/exposure_settings.h"

namespace slicefarm {

/// Data of a job that all calls of the exposure stage share.
struct ExposureJob {
  ExposureSettings settings;
  std::vector<Copy> copies;

  friend bool operator==(const ExposureJob&, const ExposureJob&) = default;
};

}  // namespace slicefarm
