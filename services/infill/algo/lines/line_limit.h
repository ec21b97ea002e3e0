#pragma once

#include <algorithm>

#include "absl/status/status.h"
#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::infill {

/// Returns REQUEST_TOO_LARGE if one region has more than limits::kMaxLinesPerFill lines. Callers
/// check this before they allocate the lines.
inline absl::Status CheckLineCount(double lines) {
  if (lines <= static_cast<double>(limits::kMaxLinesPerFill)) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "lines of one infill region",
                    limits::kMaxLinesPerFill, static_cast<int64_t>(std::min(lines, 1e18)));
}

}  // namespace slicefarm::infill
