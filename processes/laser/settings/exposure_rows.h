#pragma once

#include <vector>

#include "common/config/process_settings.h"

namespace slicefarm::config::laser {

/// The table of exposure.
class ExposureRows : public RegionRows {
 public:
  absl::StatusOr<int32_t> RowOf(const JobSettings& settings) override;
  void PutInto(JobSettings& settings) const override {
    settings.exposure.regions = rows_;
    // All tables are equally long.
    settings.beading.resize(rows_.size());
    settings.infill.resize(rows_.size());
    settings.ordering.walls.resize(rows_.size());
    settings.motion.speeds.resize(rows_.size());
  }

 private:
  std::vector<ExposureOptions> rows_;
};

}  // namespace slicefarm::config::laser
