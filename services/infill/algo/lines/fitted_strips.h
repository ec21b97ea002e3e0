#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/geometry/vector.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Point on the centre line of a bead, with the width of the strip that the bead fills there.
struct StripPoint {
  Point at;
  double strip_nm = 0;

  friend bool operator==(const StripPoint&, const StripPoint&) = default;
};

/// Returns the point at the fraction `share` of the line from a to b; its strip width is
/// interpolated too.
StripPoint Between(const StripPoint& a, const StripPoint& b, double share);

/// Strips of a region that solid lines fill. A strip normally extends half a pitch to each side of
/// its line. A line beside a part of the boundary at a small angle to the lines has a wider or
/// narrower strip: it extends to the boundary, less the strip of a link along the boundary. Lines
/// therefore leave no wedges between their ends, and overlap neither walls nor each other.
class FittedStrips {
 public:
  /// Parameters of fitted strips.
  struct Options {
    /// Indexed by crossing (ScanLines::crossings): true if a link leads from it to the next
    /// crossing of its ring.
    std::vector<bool> linked;
    double link_nm = 0;  ///< width of the links' strips
    /// distance by which the filled area extends beyond the region of `lines`
    double reach_nm = 0;
  };

  /// Creates plain strips, all as wide as the pitch.
  explicit FittedStrips(const ScanLines& lines) : lines_(lines) {}

  /// Creates fitted strips. `lines` must outlive this object. Cost: O(n + k log k), n points of the
  /// region, k pieces.
  FittedStrips(const ScanLines& lines, const Options& options);

  /// Returns the centre line and the strip widths of one piece. The result begins at the piece's
  /// crossing with the index `place` in ScanLines::order, and has at least two points.
  std::vector<StripPoint> From(int32_t place) const;

 private:
  /// Extra width of a strip on one side of its line, in nm, at the position `u` along the line. 0:
  /// the strip extends half a pitch to this side. May be negative.
  struct Knot {
    double u = 0;
    double more_nm = 0;
  };
  /// Extra widths on one side of a piece, along one part of the boundary beside it. Outside of its
  /// knots there is no extra width.
  struct ExtraWidth {
    int32_t side = 0;  ///< 2 * index of the piece; + 1 for the side above the piece (greater v)
    std::vector<Knot> knots;
  };
  /// Part of the boundary at a small angle to the lines, from one crossing to the next, and the
  /// piece beside it.
  struct FlatSpan {
    std::vector<Vector2> curve;  ///< points as (u, v), with increasing u
    size_t first = 0, last = 0;
    int32_t line = 0, piece = 0;
    bool region_above = false;
    /// Distance outside of the region that is filled, measured perpendicular to the lines.
    double reach_nm = 0;
  };

  std::optional<FlatSpan> FlatFrom(int32_t from, double reach_nm) const;
  void AddSpan(const FlatSpan& flat, int32_t from, double link_nm);
  double ExtraWidthAt(const FlatSpan& flat, size_t i) const;
  std::vector<Vector2> CurveOf(int32_t from) const;
  int32_t LineBelow(int32_t from, const std::vector<Vector2>& curve) const;
  int32_t PieceBeside(int32_t line, double from_u, double to_u) const;
  std::vector<Knot> Joined(std::vector<Knot> edge, bool own_start, bool own_end) const;
  std::vector<Knot> KnotsOf(int32_t side) const;
  static double MoreAt(const std::vector<Knot>& knots, double u);

  const ScanLines& lines_;
  std::vector<ExtraWidth> extra_widths_;  ///< extra widths, sorted by side, then along the side
};

}  // namespace slicefarm::infill
