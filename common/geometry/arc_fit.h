#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace slicefarm {

/// A point of the plane, in whole micrometres.
struct PlaceUm {
  int32_t x = 0;
  int32_t y = 0;

  friend bool operator==(const PlaceUm&, const PlaceUm&) = default;
};

/// A piece of a polyline: one of its segments, or an arc that replaces several segments. It begins
/// at the end of the previous piece.
struct CurvePiece {
  size_t last = 0;  ///< index of the piece's last point in the polyline
  bool is_arc = false;
  PlaceUm centre;
  bool clockwise = false;

  friend bool operator==(const CurvePiece&, const CurvePiece&) = default;
};

/// Default of `tolerance_um`: the largest distance between an arc and the polyline that it
/// replaces, measured from any point of either.
inline constexpr double kArcToleranceUm = 25;

/// Replaces segments of a polyline by arcs where they fit, starting at its first point. Each arc is
/// as long as possible, and fulfils these conditions:
/// - The arc is within the tolerance of its segments, and has their length to 0.1 %.
/// - It replaces at least three segments, all bending in the same direction, by less than a full
///   circle in total.
/// - Both ends have the same distance from the centre, except for the rounding of the centre.
///
/// Shapes: points[0] to points[n - 1]; pieces end at increasing indices, the last at n - 1. No two
/// neighbouring points are the same. REQUIRES: tolerance_um > 1.5, because rounding uses 1.5 of it.
/// Cost: O(n log n) where arcs are long, n points.
std::vector<CurvePiece> FitArcs(std::span<const PlaceUm> points,
                                double tolerance_um = kArcToleranceUm);

}  // namespace slicefarm
