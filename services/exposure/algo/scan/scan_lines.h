#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/line_axes.h"
#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Parallel lines at v = (line + phase) * pitch for all whole numbers `line`.
struct LineGrid {
  double pitch_nm = 0;
  double phase = 0;  ///< in [0, 1)

  double V(int32_t line) const { return (line + phase) * pitch_nm; }
};

/// The part of a line between two crossings of a region's border.
struct ScanPiece {
  int32_t line = 0;
  double u0 = 0;  ///< < u1
  double u1 = 0;
};

/// A layer may have this many.
inline constexpr int64_t kMaxScanPieces = 50'000'000;

/// Cuts a region into pieces of lines, by line, then along it. A line meets an edge under a
/// half-open rule, so it meets every ring an even number of times.
/// Errors: REQUEST_TOO_LARGE for more than kMaxScanPieces; found before they are allocated.
/// Cost:   O(n + k), k pieces, but for sorting those of one line.
absl::StatusOr<std::vector<ScanPiece>> CutScanLines(const MultiPolygon& region,
                                                    const LineAxes& frame, const LineGrid& grid);

/// A region to be hatched, and where its lines end before its border.
struct HatchRegion {
  MultiPolygon area;
  /// What the area is part of; empty: the area itself. Lines end before the border of this alone.
  MultiPolygon whole = {};
  /// No lines here.
  MultiPolygon narrow = {};
  /// Along the line; of pieces shorter than four times as much a quarter of their length, and those
  /// not longer than it are left out.
  double trim_nm = 0;
};

/// The pieces of CutScanLines, trimmed where they meet the border of the whole, without those parts
/// that lie where no lines are to be.
/// Errors, cost: as CutScanLines.
absl::StatusOr<std::vector<ScanPiece>> CutTrimmedLines(const HatchRegion& region,
                                                       const LineAxes& frame, const LineGrid& grid);

}  // namespace slicefarm::exposure
