#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/line_axes.h"
#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Parallel lines at v = (line + phase) * pitch for all integers `line`.
struct LineGrid {
  double pitch_nm = 0;
  double phase = 0;  ///< in [0, 1)

  double V(int32_t line) const { return (line + phase) * pitch_nm; }
};

/// Part of a line between two crossings of a region's border.
struct ScanPiece {
  int32_t line = 0;
  double u0 = 0;  ///< start; less than u1
  double u1 = 0;
};

/// Largest number of pieces in a layer.
inline constexpr int64_t kMaxScanPieces = 50'000'000;

/// Cuts a region into pieces of lines, sorted by line, then along the line. A line meets an edge by
/// a half-open rule, so that it meets every ring an even number of times. Errors: REQUEST_TOO_LARGE
/// for more than kMaxScanPieces, checked before the allocation. Cost: O(n + k), k pieces, plus
/// sorting of the pieces of each line.
absl::StatusOr<std::vector<ScanPiece>> CutScanLines(const MultiPolygon& region,
                                                    const LineAxes& frame, const LineGrid& grid);

/// Region to be hatched, and the distance between its lines' ends and its border.
struct HatchRegion {
  MultiPolygon area;
  /// Whole area that the area is part of; empty: the area itself. Lines are shortened only at the
  /// border of the whole area.
  MultiPolygon whole = {};
  /// Area without lines.
  MultiPolygon narrow = {};
  /// Distance along the line. A piece shorter than four times this loses a quarter of its length at
  /// each end. A piece not longer than this is omitted.
  double trim_nm = 0;
};

/// Returns the pieces of CutScanLines, shortened at the border of the whole area, without the parts
/// in the area without lines. Errors, cost: as CutScanLines.
absl::StatusOr<std::vector<ScanPiece>> CutTrimmedLines(const HatchRegion& region,
                                                       const LineAxes& frame, const LineGrid& grid);

}  // namespace slicefarm::exposure
