#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/vector.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Rows of one wave. Row i is at v = i * apart_nm; odd rows are mirrored in v, so that neighbours
/// approach each other and move apart in turn.
struct WaveRows {
  double angle_rad = 0;
  bool transposed = false;  ///< true: u and v are exchanged, so that the rows run along v
  double apart_nm = 0;
  double period_nm = 0;
  /// Points of one period of row 0, by ascending u in [0, period_nm), in nm; empty: straight rows.
  std::span<const Vector2> wave = {};
};

/// Returns the rows that meet a region, not yet cut to it. Errors: REQUEST_TOO_LARGE for more than
/// limits::kMaxLinesPerFill segments. Cost: O(segments).
absl::StatusOr<std::vector<Curve>> RowsOver(const MultiPolygon& region, const WaveRows& rows);

}  // namespace slicefarm::infill
