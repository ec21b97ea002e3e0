#include "services/planning/algo/supports/generator/widened.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::planning {
namespace {

/// Returns the mean width of a strip: its area divided by half the length of its edges.
Coord MeanWidth(const PolygonWithHoles& island) {
  double edges = 0;
  ForEachRing({island}, [&](const Polygon& ring) { edges += Perimeter(ring); });
  return std::llround(2 * Area(island) / edges);
}

}  // namespace

MultiPolygon Widened(const MultiPolygon& islands, Coord width_nm) {
  MultiPolygon widened;
  for (const PolygonWithHoles& island : islands) {
    const Coord missing = width_nm - MeanWidth(island);
    if (missing <= 0) continue;
    MultiPolygon wide = FastOffset({island}, missing / 2);
    std::move(wide.begin(), wide.end(), std::back_inserter(widened));
  }
  return widened;
}

}  // namespace slicefarm::planning
