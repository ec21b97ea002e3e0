#include "common/geometry/moved.h"

#include <utility>

namespace slicefarm {

Polygon Moved(Polygon ring, Point by) {
  for (Point& p : ring) p = p + by;
  return ring;
}

MultiPolygon Moved(MultiPolygon polygons, Point by) {
  for (PolygonWithHoles& polygon : polygons) {
    polygon.outer = Moved(std::move(polygon.outer), by);
    for (Polygon& hole : polygon.holes) hole = Moved(std::move(hole), by);
  }
  return polygons;
}

}  // namespace slicefarm
