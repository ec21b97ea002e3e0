#include "services/infill/algo/skins/expanded_tops.h"

#include <algorithm>
#include <iterator>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/without_holes.h"
#include "common/geometry/box_index.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::infill {
namespace {

MultiPolygon Grown(const MultiPolygon& top, const SurfaceOptions& surfaces) {
  MultiPolygon grown = FastOffset(top, surfaces.expansion_nm);
  if (surfaces.expansion_direction == ExpansionDirection::kBoth) return grown;
  const MultiPolygon filled = WithoutHoles(top);
  if (surfaces.expansion_direction == ExpansionDirection::kInward)
    return Intersection(grown, filled);
  return Difference(grown, Difference(filled, top));
}

}  // namespace

MultiPolygon TopGrowth(const MultiPolygon& outline, const MultiPolygon& above,
                       const GrowthRules& rules) {
  MultiPolygon growth;
  const BoxIndex index(above);
  for (const PolygonWithHoles& island : outline) {
    const MultiPolygon inside = FastOffset({island}, -rules.walls_nm);
    if (inside.empty()) continue;
    const MultiPolygon over = IslandsNear(Bounds(inside), above, index);
    const MultiPolygon top = Difference(inside, over);
    if (top.empty() || FastOffset(top, -rules.width_nm).empty()) continue;
    const Coord margin_nm = rules.surfaces.expansion_margin_nm;
    const MultiPolygon allowed = margin_nm > 0 ? FastOffset(inside, -margin_nm) : inside;
    std::ranges::move(Intersection(Intersection(Grown(top, rules.surfaces), allowed), over),
                      std::back_inserter(growth));
  }
  return outline.size() > 1 ? Union(Rings(growth), FillRule::kNonZero) : growth;
}

}  // namespace slicefarm::infill
