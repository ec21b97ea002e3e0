#include "services/exposure/algo/scan/border_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/measure.h"

namespace slicefarm::exposure {

double DistanceToBorder(PlaneVector place, const MultiPolygon& region) {
  const Point p{std::llround(place.x), std::llround(place.y)};
  double nearest = std::numeric_limits<double>::infinity();
  ForEachRing(region, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      nearest = std::min(nearest, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
  });
  return nearest;
}

bool IsWithin(PlaneVector place, double distance_nm, const MultiPolygon& region) {
  const Point p{std::llround(place.x), std::llround(place.y)};
  return std::ranges::any_of(region,
                             [p](const PolygonWithHoles& island) {
                               return Locate(p, island) != Side::kOutside;
                             }) &&
         DistanceToBorder(place, region) >= distance_nm;
}

}  // namespace slicefarm::exposure
