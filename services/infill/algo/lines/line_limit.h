#pragma once

#include <algorithm>

#include "absl/status/status.h"
#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::infill {

/// REQUEST_TOO_LARGE for more lines than limits::kMaxLinesPerFill in one region, before anything is
/// allocated for them.
inline absl::Status CheckLineCount(double lines) {
  if (lines <= static_cast<double>(limits::kMaxLinesPerFill)) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "lines of one infill region",
                    limits::kMaxLinesPerFill, static_cast<int64_t>(std::min(lines, 1e18)));
}

}  // namespace slicefarm::infill
