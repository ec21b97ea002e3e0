#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/line_axes.h"
#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Parallel lines with the equation v = (line + phase) * pitch, one for each integer `line`.
struct LineGrid {
  double pitch_nm = 0;
  double phase = 0;  ///< in [0, 1)

  double V(int32_t line) const { return (line + phase) * pitch_nm; }
};

/// Part of a line inside a region: between two consecutive crossings of the region's boundary.
struct ScanPiece {
  int32_t line = 0;
  double u0 = 0;  ///< start of the piece; smaller than u1
  double u1 = 0;
};

/// Largest number of pieces in a layer.
inline constexpr int64_t kMaxScanPieces = 50'000'000;

/// Cuts lines into the pieces inside a region, sorted by line, then along the line. A line meets an
/// edge by a half-open rule, so that it meets every ring an even number of times. Errors:
/// REQUEST_TOO_LARGE for more than kMaxScanPieces, checked before the allocation. Cost: O(n + k), n
/// points of the region, k pieces, plus sorting of the pieces of each line.
absl::StatusOr<std::vector<ScanPiece>> CutScanLines(const MultiPolygon& region,
                                                    const LineAxes& frame, const LineGrid& grid);

/// Region to be hatched, and rules for the ends of its lines.
struct HatchRegion {
  MultiPolygon area;
  /// Larger area that contains `area`; empty: `area` itself. Lines are shortened only where they
  /// end at the boundary of this larger area.
  MultiPolygon whole = {};
  /// Part of `area` without lines.
  MultiPolygon narrow = {};
  /// Length by which each end of a piece is shortened. A piece shorter than four times this length
  /// loses a quarter of its own length at each end. A piece not longer than `trim_nm` is omitted.
  double trim_nm = 0;
};

/// Returns the pieces of CutScanLines for `region.area`, shortened at the boundary of
/// `region.whole`, without the parts in `region.narrow`. Errors and cost: see CutScanLines.
absl::StatusOr<std::vector<ScanPiece>> CutTrimmedLines(const HatchRegion& region,
                                                       const LineAxes& frame, const LineGrid& grid);

}  // namespace slicefarm::exposure
