#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/model/options/settings.h"
#include "common/model/process.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm {

/// Resolved set of exposure settings with one row of each scope.
struct ExposureRows {
  static constexpr Process kProcess = Process::kLaser;

  ExposureOptions region;
  ExposureOutput output;

  friend bool operator==(const ExposureRows&, const ExposureRows&) = default;
};

/// Exposure settings of a plate. The `settings` index of a Region is a row of `regions`.
struct ExposureSettings {
  static constexpr Process kProcess = Process::kLaser;

  std::vector<ExposureOptions> regions = {{}};
  ExposureOutput output;

  friend bool operator==(const ExposureSettings&, const ExposureSettings&) = default;
};

// Returns the exposure settings of a job. REQUIRES: the job is an exposure job.
inline const ExposureSettings& ExposureOf(const JobSettings& settings) { return settings.own.As<ExposureSettings>(); }
inline ExposureSettings& ExposureOf(JobSettings& settings) { return settings.own.As<ExposureSettings>(); }
inline const ExposureRows& ExposureOf(const JobRows& rows) { return rows.own.As<ExposureRows>(); }
inline ExposureRows& ExposureOf(JobRows& rows) { return rows.own.As<ExposureRows>(); }

/// Returns how many of an object's own layers on each side a layer's result depends on.
inline int32_t HaloLayers(const ExposureSettings& settings) {
  int32_t halo = 0;
  for (const ExposureOptions& region : settings.regions) halo = std::max(halo, region.Halo());
  return halo;
}

}  // namespace slicefarm
