#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace slicefarm {

/// A place in the plane, in whole micrometres.
struct PlaceUm {
  int32_t x = 0;
  int32_t y = 0;

  friend bool operator==(const PlaceUm&, const PlaceUm&) = default;
};

/// A stretch of a polyline: one of its segments, or an arc that stands for several.
struct CurvePiece {
  size_t last = 0;  ///< index of the point at which it ends
  bool is_arc = false;
  PlaceUm centre;
  bool clockwise = false;

  friend bool operator==(const CurvePiece&, const CurvePiece&) = default;
};

/// How far an arc and the polyline that it stands for may lie apart, at any place of either, unless
/// told otherwise.
inline constexpr double kArcToleranceUm = 25;

/// A polyline as arcs where they fit, from its first point on, each as long as it can be:
///   within the tolerance, and as long as its segments to 0.1 %;
///   at least three segments, all turning the same way, less than a whole turn;
///   both ends equally far from the centre, up to the rounding of the centre.
/// Shapes: points[0] to points[n - 1]; pieces end at increasing indices, the last at n - 1. No two
/// neighbouring points are the same. REQUIRES: tolerance_um > 1.5, which rounding takes. Cost: O(n
/// log n) where arcs are long.
std::vector<CurvePiece> FitArcs(std::span<const PlaceUm> points,
                                double tolerance_um = kArcToleranceUm);

}  // namespace slicefarm
