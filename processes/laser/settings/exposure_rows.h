#pragma once

#include <vector>

#include "common/config/process_settings.h"

namespace slicefarm::config::laser {

/// The table of exposure.
class ExposureRows : public RegionRows {
 public:
  absl::StatusOr<int32_t> RowOf(const JobSettings& settings) override;
  int64_t size() const override { return std::ssize(rows_); }
  void PutInto(JobSettings& settings) const override { ExposureOf(settings).regions = rows_; }

 private:
  std::vector<ExposureOptions> rows_;
};

}  // namespace slicefarm::config::laser
