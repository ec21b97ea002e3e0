#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace slicefarm {

/// A point of the plane, in whole micrometres.
struct PointUm {
  int32_t x = 0;
  int32_t y = 0;

  friend bool operator==(const PointUm&, const PointUm&) = default;
};

/// A piece of a polyline: one of its segments, or an arc that replaces several segments. A piece
/// begins at the last point of the previous piece.
struct CurvePiece {
  size_t last = 0;  ///< index of the piece's last point in the polyline
  bool is_arc = false;
  PointUm centre;
  bool clockwise = false;

  friend bool operator==(const CurvePiece&, const CurvePiece&) = default;
};

/// Default of `tolerance_um`: the largest distance between an arc and the polyline that it
/// replaces, measured from any point of either.
inline constexpr double kArcToleranceUm = 25;

/// Replaces segments of a polyline by arcs where possible, from the first point to the last. Each
/// arc is as long as possible, and fulfils these conditions:
/// - Its distance from the segments is nowhere more than the tolerance. Its length equals the
///   length of the segments to 0.1 %.
/// - It replaces at least three segments, all bending in the same direction, by less than a full
///   circle in total.
/// - Both ends have the same distance from the centre, except for the rounding of the centre.
///
/// The pieces are in the order of the polyline; the last one ends at the last point. REQUIRES: no
/// two neighbouring points are the same; tolerance_um > 1.5, because rounding uses 1.5 of it. Cost
/// for n points: O(n log n) if arcs are long.
std::vector<CurvePiece> FitArcs(std::span<const PointUm> points,
                                double tolerance_um = kArcToleranceUm);

}  // namespace slicefarm
