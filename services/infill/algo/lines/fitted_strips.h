#pragma once

#include <cstdint>
#include <vector>

#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// A place on the middle of a bead, and how wide a strip the bead fills there.
struct StripPoint {
  Point at;
  double strip_nm = 0;

  friend bool operator==(const StripPoint&, const StripPoint&) = default;
};

/// The strips of a region that solid lines fill, one for each piece of line: half a pitch to each
/// side of it. But where the region's edge runs at a flat angle to the lines, a strip goes as far
/// as the edge: it is narrower where the line runs into the edge, and wider, by half a pitch at
/// most, beside the end of the next line and below the top of a slope that no line reaches. So
/// lines leave no wedge between their ends, and do not lie over what is beyond the edge.
///
/// Where a link runs along the edge, strips end before it, so that it fills its own.
class FittedStrips {
 public:
  /// None reaches farther than half a pitch, or less far.
  explicit FittedStrips(const ScanLines& lines) : lines_(lines) {}

  /// `linked`: by crossing, whether a link runs from it to the next one on its ring. `reach_nm`:
  /// what lies outside of the region of `lines` and is filled too; links fill twice as much, half
  /// of it inside. `lines` must outlive this. Cost: O(n + k log k), n points of the region, k
  /// pieces.
  FittedStrips(const ScanLines& lines, const std::vector<bool>& linked, double reach_nm);

  /// The strip of the piece that begins at `place` (ScanLines::order), to its other end: two points
  /// or more.
  std::vector<StripPoint> From(int32_t place) const;

 private:
  /// How much farther than half a pitch a strip goes at a place along it.
  struct Knot {
    double u = 0;
    double more_nm = 0;
  };
  /// What a stretch of the edge leaves on one side of a piece; nothing more where there is none.
  struct Room {
    int32_t side = 0;  ///< twice the piece, and one above it
    std::vector<Knot> knots;
  };
  struct FramePoint {
    double u = 0, v = 0;
  };

  void AddStretch(int32_t from, double reach_nm);
  std::vector<FramePoint> WayOf(int32_t from) const;
  int32_t LineBelow(int32_t from, const std::vector<FramePoint>& way) const;
  int32_t PieceBeside(int32_t line, double from_u, double to_u) const;
  std::vector<Knot> Joined(std::vector<Knot> edge, bool own_start, bool own_end) const;
  std::vector<Knot> KnotsOf(int32_t side) const;
  static double MoreAt(const std::vector<Knot>& knots, double u);

  const ScanLines& lines_;
  std::vector<Room> rooms_;  ///< by side, then along it
};

}  // namespace slicefarm::infill
