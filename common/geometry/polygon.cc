#include "common/geometry/polygon.h"

#include <algorithm>

namespace slicefarm {
namespace {

void StartAtLeastPoint(Polygon& ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
}

}  // namespace

void Canonicalize(MultiPolygon& polygons) {
  for (PolygonWithHoles& polygon : polygons) {
    StartAtLeastPoint(polygon.outer);
    for (Polygon& hole : polygon.holes) StartAtLeastPoint(hole);
    std::sort(polygon.holes.begin(), polygon.holes.end());
  }
  std::sort(polygons.begin(), polygons.end(),
            [](const PolygonWithHoles& a, const PolygonWithHoles& b) {
              return a.outer != b.outer ? a.outer < b.outer : a.holes < b.holes;
            });
}

std::vector<Polygon> Rings(const MultiPolygon& polygons) {
  std::vector<Polygon> rings;
  ForEachRing(polygons, [&](const Polygon& ring) { rings.push_back(ring); });
  return rings;
}

size_t PointCount(const MultiPolygon& polygons) {
  size_t count = 0;
  ForEachRing(polygons, [&](const Polygon& ring) { count += ring.size(); });
  return count;
}

}  // namespace slicefarm
