#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/vector.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Rows of one wave, along u. Row i is at v = i * apart_nm. Odd rows are mirrored in v, so that
/// neighbouring rows alternately approach each other and move apart.
struct WaveRows {
  double angle_rad = 0;
  bool transposed = false;  ///< true: u and v are exchanged, so that the rows lead along v
  double apart_nm = 0;
  double period_nm = 0;
  /// Points of one period of row 0, in nm, sorted by u in [0, period_nm); empty: straight rows.
  std::span<const Vector2> wave = {};
};

/// Returns the rows that pass the bounding box of a region, not yet cut to the region. Errors:
/// REQUEST_TOO_LARGE for more than limits::kMaxLinesPerFill segments. Cost: O(segments).
absl::StatusOr<std::vector<Curve>> RowsOver(const MultiPolygon& region, const WaveRows& rows);

}  // namespace slicefarm::infill
