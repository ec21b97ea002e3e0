#include "services/infill/algo/skins/expanded_tops.h"

#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::infill {
namespace {

/// Returns the polygons without their holes.
MultiPolygon Filled(const MultiPolygon& polygons) {
  MultiPolygon filled;
  for (const PolygonWithHoles& polygon : polygons) filled = Union(filled, {{polygon.outer, {}}});
  return filled;
}

MultiPolygon Grown(const MultiPolygon& top, const SurfaceOptions& surfaces) {
  MultiPolygon grown = FastOffset(top, surfaces.expansion_nm);
  if (surfaces.expansion_direction == ExpansionDirection::kBoth) return grown;
  const MultiPolygon filled = Filled(top);
  if (surfaces.expansion_direction == ExpansionDirection::kInward)
    return Intersection(grown, filled);
  return Difference(grown, Difference(filled, top));
}

}  // namespace

MultiPolygon TopGrowth(const MultiPolygon& outline, const MultiPolygon& above,
                       const GrowthRules& rules) {
  MultiPolygon growth;
  for (const PolygonWithHoles& island : outline) {
    const MultiPolygon inside = FastOffset({island}, -rules.walls_nm);
    if (inside.empty()) continue;
    const MultiPolygon top = Difference(inside, above);
    if (top.empty() || FastOffset(top, -rules.width_nm).empty()) continue;
    const Coord margin_nm = rules.surfaces.expansion_margin_nm;
    const MultiPolygon allowed = margin_nm > 0 ? FastOffset(inside, -margin_nm) : inside;
    MultiPolygon grown = Intersection(Intersection(Grown(top, rules.surfaces), allowed), above);
    growth = growth.empty() ? std::move(grown) : Union(growth, grown);
  }
  return growth;
}

}  // namespace slicefarm::infill
