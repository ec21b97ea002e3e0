#pragma once

#include <cstdint>

#include "absl/status/status.h"
#include "common/base/error.h"

namespace slicefarm::infill {

/// Largest number of cells of a grid of one layer, for distances, dithering or streamlines. An
/// object of 0.5 m by 0.5 m has this many of the finest cells.
inline constexpr int64_t kMaxFieldCells = 1'200'000;
/// Largest number of points of all streamlines of one region.
inline constexpr int64_t kMaxStreamPoints = 10'000'000;

/// Returns REQUEST_TOO_LARGE if `got`, the number of cells that are needed, exceeds `limit`.
/// Callers check this before they allocate the cells.
inline absl::Status CheckFieldSize(int64_t limit, double got) {
  if (got <= static_cast<double>(limit)) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "cells of a field in one layer", limit,
                    static_cast<int64_t>(got < 1e18 ? got : 1e18));
}

}  // namespace slicefarm::infill
