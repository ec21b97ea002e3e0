#pragma once

#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// The rear-most vertex, of these the left-most. REQUIRES: ring not empty.
Point RearMost(const Polygon& ring);

/// How little a vertex suits a seam, as the distance in mm that is worth going for a better one: 0
/// at a sharp inner corner, which hides it; more at a sharp outer corner, most where the outline is
/// straight. The corner is that of the two points 0.5 mm along the ring before and after, so that
/// fine facets do not hide it. Units: mm in [0, 2]. Cost: O(points within 0.5 mm).
double SeamPenaltyMm(const Polygon& ring, size_t vertex);

/// Seams in line, of one object: goes up its layers and puts each ring's seam where it is close to
/// the chain of an overlapping ring in the layer below, and at a corner if one is near. The chain
/// goes along with corners at once and with other vertices slowly, so that facets that turn from
/// layer to layer do not carry it away. A ring with none below starts a chain at its best corner, of
/// these the rear-most.
class SeamChain {
 public:
  /// Seams of the next layer, one a ring: by island, outer ring before holes.
  std::vector<Point> Next(const MultiPolygon& outlines);

 private:
  struct Link {
    bool hole = false;
    Box box;
    Point target;  ///< where the next layer's seam should be
  };

  Point Place(bool hole, const Polygon& ring);

  std::vector<Link> below_;
  std::vector<Link> current_;
};

}  // namespace slicefarm::planning
