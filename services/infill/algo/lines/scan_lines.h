#pragma once

#include <cstdint>
#include <vector>

#include "absl/status/statusor.h"
#include "common/geometry/line_axes.h"
#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Parallel lines at v = phase + i * pitch for all integers i. The u axis of their frame (LineAxes)
/// has the angle `angle_rad`; lines lead along u.
struct LineFamily {
  double angle_rad = 0;
  double phase_nm = 0;
  double pitch_nm = 0;
};

/// Crossing of a scan line and a ring.
struct Crossing {
  double u = 0;
  int32_t line = 0;  ///< index of the line, counted from the first line that meets the region
  int32_t ring = 0;
  int32_t edge = 0;      ///< index of the ring's edge: from its point `edge` to the next
  int32_t previous = 0;  ///< previous crossing along the ring
  int32_t next = 0;      ///< next crossing along the ring
  /// Index of this crossing in ScanLines::order. The index `place ^ 1` belongs to the other end of
  /// the same piece.
  int32_t place = 0;
};

/// Pieces of a line family inside a region, with their connections along the boundary.
struct ScanLines {
  LineAxes frame{0};
  std::vector<const Polygon*> rings;  ///< rings of the region, which must outlive this struct
  double first_v = 0;                 ///< v of line 0
  double pitch = 0;
  std::vector<Crossing> crossings;
  /// Indices in `crossings`, sorted by line, then by u. Entries 2k and 2k + 1 are the ends of piece
  /// k.
  std::vector<int32_t> order;
  /// Index in `order` of each line's first crossing; one more entry than lines.
  std::vector<int32_t> line_begin;

  int32_t LineCount() const { return static_cast<int32_t>(line_begin.size()) - 1; }
  int32_t PieceCount() const { return static_cast<int32_t>(order.size() / 2); }
  double VOf(int32_t line) const { return first_v + pitch * line; }
  /// Returns the crossing's position in the plane, rounded to nm.
  Point PointOf(const Crossing& crossing) const;
  /// Returns the length of one piece, in nm.
  double PieceLength(int32_t piece) const;
  /// Returns the total length of all pieces, in nm.
  double TotalLength() const;
};

/// Cuts the lines of a family into pieces inside `region`. A line meets an edge by a half-open
/// rule. Therefore every line meets every ring an even number of times, even if the line passes
/// through vertices. REQUIRES: family.pitch_nm > 0; `region` outlives the result.
///
/// Precision: ends are rounded once to nm, and are within 1 nm of the boundary. Errors:
/// InvalidArgument with REQUEST_TOO_LARGE, `limit` and `got`, for more pieces than
/// limits::kMaxLinesPerFill; checked before the allocation. Cost: O(n + k + k log k'), n points, k
/// crossings, at most k' of them on one line.
absl::StatusOr<ScanLines> CutLines(const MultiPolygon& region, const LineFamily& family);

}  // namespace slicefarm::infill
