#include "services/planning/algo/support/widened.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::planning {
namespace {

/// Of a strip: its area over half of its edges, all in all.
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

MultiPolygon WhereWide(const MultiPolygon& region, Coord width_nm) {
  const MultiPolygon core = FastOffset(region, -width_nm / 2);
  // A little more, so that what is wide keeps its edges whatever rounding did.
  return core.empty() ? core : Intersection(region, FastOffset(core, width_nm * 11 / 20));
}

}  // namespace slicefarm::planning
