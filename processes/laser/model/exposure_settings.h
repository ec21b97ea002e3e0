#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/model/options/settings.h"
#include "common/model/process.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm {

/// Resolved exposure settings of one region: one row of each table.
struct ExposureRows {
  static constexpr Process kProcess = Process::kLaser;

  ExposureOptions region;
  ExposureOutput output;

  friend bool operator==(const ExposureRows&, const ExposureRows&) = default;
};

/// Exposure settings of a plate. Region::settings is an index into `regions`.
struct ExposureSettings {
  static constexpr Process kProcess = Process::kLaser;

  std::vector<ExposureOptions> regions = {{}};
  ExposureOutput output;

  friend bool operator==(const ExposureSettings&, const ExposureSettings&) = default;
};

// Returns the exposure settings of a job. REQUIRES: the job is an exposure job.
inline const ExposureSettings& ExposureOf(const JobSettings& settings) {
  return settings.own.As<ExposureSettings>();
}
inline ExposureSettings& ExposureOf(JobSettings& settings) {
  return settings.own.As<ExposureSettings>();
}
inline const ExposureRows& ExposureOf(const JobRows& rows) { return rows.own.As<ExposureRows>(); }
inline ExposureRows& ExposureOf(JobRows& rows) { return rows.own.As<ExposureRows>(); }

/// Returns the number of an object's own layers above and below a layer on which the result of this
/// layer depends.
inline int32_t HaloLayers(const ExposureSettings& settings) {
  int32_t halo = 0;
  for (const ExposureOptions& region : settings.regions) halo = std::max(halo, region.Halo());
  return halo;
}

}  // namespace slicefarm
