#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "common/geometry/vector.h"

namespace slicefarm::slicing {

/// Grid step of the positions where a part can be placed (translations of its footprint), 1 um.
inline constexpr Coord kPositionStep = 1'000;

/// Positions at which a part can be placed on one plate. Only the candidates that matter for
/// packing are stored. They are updated when other parts are added.
///
/// A part with hull H may be moved by t if H + t is in the bed and t is strictly inside no
/// obstacle. Obstacles are no-fit polygons: Minkowski sums of the placed parts with the mirrored
/// part and the clearance. The minimum of any convex cost over the free translations is at a corner
/// of the free region, or at the boundary point nearest to a target. So only these points are kept:
/// corners and crossings of the outlines of obstacles and bed, and on each edge the point nearest
/// to the target.
///
/// Each point is rounded to kPositionStep in all four directions and tested exactly. So a gap that
/// fits exactly is found, and rounding never brings parts too close together. If the end of a wedge
/// is so sharp that it contains no grid point, points up to 0.25 mm farther out are tried.
///
/// Cost of adding an obstacle: O(k m) for the k obstacles that meet it, with m corners each, and
/// O(c k) for the c candidate points on the obstacle.
class FreePositions {
 public:
  /// REQUIRES: bed and hull are convex (common/geometry/convex.h), the bed has at least three
  /// points. `target`: the translation that the packing prefers.
  FreePositions(const Polygon& bed, const Polygon& hull, Point target);

  /// Forbids all translations strictly inside one of the convex polygons `obstacles`. One call with
  /// many polygons is cheaper than many calls.
  void AddObstacles(std::vector<Polygon> obstacles);

  /// Returns the stored candidates, in no particular order.
  const std::vector<Point>& Positions() const { return places_; }

  /// Returns true if the part may be moved by `t`. Exact. Cost: O(b + k) for b corners of the bed
  /// and k obstacles around t.
  bool Allowed(Point t) const;

 private:
  struct Limit {
    Point from, along;  ///< start of a bed edge, and the vector along it
    Point corner;       ///< corner of the hull that would first leave the bed over this edge
  };
  struct Obstacle {
    Polygon ring;
    Box box;
    std::vector<Vector2> spots;  ///< corners of the ring
  };
  struct Segment {
    Vector2 a, b;
  };

  bool InBed(Point t) const;
  std::vector<Vector2> BedRing(const Polygon& bed) const;
  size_t CellOf(Coord x, Coord y) const;
  void Register(Polygon ring);
  void OfferAlong(const std::vector<Vector2>& ring);
  void OfferCrossings(const std::vector<Vector2>& a, const std::vector<Vector2>& b,
                      const Box& common);
  void OfferCrossing(const Segment& a, const Segment& b);
  bool Offer(Vector2 spot);
  static std::vector<Segment> Within(const std::vector<Vector2>& ring, const Box& box);

  static constexpr Coord kCells = 16;  ///< number of cells in each direction

  Point target_;
  std::vector<Limit> limits_;
  /// boundary of the translations that keep the hull in the bed, clockwise
  std::vector<Vector2> bed_ring_;
  Box bed_box_;  ///< box around `bed_ring_`
  std::vector<Obstacle> obstacles_;
  /// indices of the obstacles that meet each cell; kCells x kCells cells cover bed_box_
  std::vector<std::vector<uint32_t>> cells_;
  std::vector<Point> places_;
};

}  // namespace slicefarm::slicing
