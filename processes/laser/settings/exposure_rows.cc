#include "processes/laser/settings/exposure_rows.h"

#include <algorithm>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::config::laser {

absl::StatusOr<int32_t> ExposureRows::RowOf(const JobSettings& settings) {
  const ExposureOptions& region = ExposureOf(settings).regions.front();
  const auto found = std::ranges::find(rows_, region);
  if (found != rows_.end()) return static_cast<int32_t>(found - rows_.begin());
  const int64_t rows = std::ssize(rows_) + 1;
  if (rows > limits::kMaxRegionSettings)
    return LimitError(Reason::kRequestTooLarge, "different sets of settings of regions",
                      limits::kMaxRegionSettings, rows);
  rows_.push_back(region);
  return static_cast<int32_t>(rows - 1);
}

}  // namespace slicefarm::config::laser
