#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::config {

/// Table of different rows of settings. Equal rows share an index.
template <typename Row>
class RowTable {
 public:
  /// Returns the index of a row; a new row is added. Cost: O(rows). Errors: REQUEST_TOO_LARGE
  /// beyond limits::kMaxRegionSettings.
  absl::StatusOr<int32_t> Add(const Row& row) {
    const auto found = std::ranges::find(rows_, row);
    if (found != rows_.end()) return static_cast<int32_t>(found - rows_.begin());
    const int64_t count = std::ssize(rows_) + 1;
    if (count > limits::kMaxRegionSettings)
      return LimitError(Reason::kRequestTooLarge, "different sets of settings of regions",
                        limits::kMaxRegionSettings, count);
    rows_.push_back(row);
    return static_cast<int32_t>(count - 1);
  }

  const std::vector<Row>& rows() const { return rows_; }

 private:
  std::vector<Row> rows_;
};

}  // namespace slicefarm::config
