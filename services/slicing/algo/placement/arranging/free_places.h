#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "common/geometry/vector.h"

namespace slicefarm::slicing {

/// Places on a grid of 1 um where a part can stand, as translations of its footprint.
inline constexpr Coord kPlaceStep = 1'000;

/// Where on one plate a part can stand: the places that matter to a packing, kept while other parts
/// come.
///
/// A part with hull H may be moved by t if H + t lies in the bed, and t lies strictly inside none
/// of the obstacles: no-fit polygons, Minkowski sums of what stands there with the part mirrored
/// and the clearance. The least of any convex cost over the free translations lies at a corner of
/// the free region or where its boundary is nearest to a target, so only these are kept: corners
/// and crossings of the outlines of obstacles and of the bed's, and the feet of the target on
/// their edges. Each is rounded to kPlaceStep in all four ways and tested exactly, so a slot that
/// fits exactly is found, and rounding never lets parts come too near. In a wedge so sharp that its
/// end holds no place of the grid, places up to 0.25 mm farther out are tried.
///
/// Cost: of each obstacle O(k m) for the k obstacles that meet it, of m corners each, and O(c k)
/// for the c places that it offers.
class FreePlaces {
 public:
  /// REQUIRES: bed and hull convex (common/geometry/convex.h), bed of at least three points.
  /// `target`: the translation that the packing would like best.
  FreePlaces(const Polygon& bed, const Polygon& hull, Point target);

  /// From now on no translation strictly inside one of these convex polygons. Many at once cost
  /// less than one by one.
  void AddObstacles(std::vector<Polygon> obstacles);

  /// All places found, without order.
  const std::vector<Point>& Places() const { return places_; }

  /// Whether the part may be moved by t. Exact. Cost: O(bed's corners + obstacles around t).
  bool Allowed(Point t) const;

 private:
  struct Limit {
    Point from, along;  ///< an edge of the bed
    Point corner;       ///< of the hull, the first to leave it
  };
  struct Obstacle {
    Polygon ring;
    Box box;
    std::vector<Vector2> spots;  ///< the ring's
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

  static constexpr Coord kCells = 16;  ///< in each direction

  Point target_;
  std::vector<Limit> limits_;
  std::vector<Vector2> bed_ring_;  ///< outline, clockwise, of the translations that stay in the bed
  Box bed_box_;                    ///< around it
  std::vector<Obstacle> obstacles_;
  std::vector<std::vector<uint32_t>> cells_;  ///< the obstacles over each cell of bed_box_
  std::vector<Point> places_;
};

}  // namespace slicefarm::slicing
