#include "services/slicing/algo/section/regions.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/rings/ring_cleaning.h"
#include "common/geometry/rings/simplify.h"
#include "services/slicing/algo/section/elephant_foot.h"
#include "services/slicing/algo/section/loop_nesting.h"

namespace slicefarm::slicing {
namespace {

Polygon SimplifiedLoop(const Polygon& loop, Coord resolution_nm) {
  return CleanedRing(resolution_nm > 0 ? SimplifyRing(loop, resolution_nm) : loop);
}

MultiPolygon Cleaned(const MultiPolygon& region) {
  MultiPolygon clean;
  clean.reserve(region.size());
  for (const PolygonWithHoles& island : region) {
    PolygonWithHoles kept{CleanedRing(island.outer), {}};
    if (kept.outer.empty()) continue;
    for (const Polygon& hole : island.holes) {
      Polygon ring = CleanedRing(hole);
      if (!ring.empty()) kept.holes.push_back(std::move(ring));
    }
    clean.push_back(std::move(kept));
  }
  Canonicalize(clean);
  return clean;
}

/// Moves the outlines of holes. Each island is treated separately, because an island in a hole does
/// not belong to the outer island.
MultiPolygon WithWiderHoles(const MultiPolygon& region, Coord by_nm) {
  MultiPolygon parts;
  for (const PolygonWithHoles& island : region) {
    MultiPolygon holes;
    for (const Polygon& hole : island.holes)
      holes.push_back({Polygon(hole.rbegin(), hole.rend()), {}});
    const MultiPolygon part = Difference({{island.outer, {}}}, Offset(holes, by_nm));
    parts.insert(parts.end(), part.begin(), part.end());
  }
  // A shrinking hole may close over the island in it, so the parts are united.
  return by_nm < 0 ? Union(Rings(parts), FillRule::kNonZero) : parts;
}

}  // namespace

MultiPolygon RegionOf(const std::vector<Polygon>& loops, FillRule rule, Coord resolution_nm) {
  std::vector<Polygon> simple;
  simple.reserve(loops.size());
  for (const Polygon& loop : loops) {
    Polygon ring = SimplifiedLoop(loop, resolution_nm);
    if (!ring.empty()) simple.push_back(std::move(ring));
  }
  if (std::optional<MultiPolygon> nested = NestSimpleLoops(simple, rule)) return *std::move(nested);
  return Cleaned(Union(simple, rule));
}

namespace {

/// Returns the elephant foot compensation of a layer: it falls evenly over elephant_foot_layers. A
/// negative compensation is only for the first layer.
Coord FootAt(int32_t layer, const ObjectSlicingOptions& options) {
  const int32_t layers = options.elephant_foot_nm > 0 ? options.elephant_foot_layers : 1;
  return layer < layers ? options.elephant_foot_nm * (layers - layer) / layers : 0;
}

}  // namespace

RegionEdits EditsFor(int32_t layer, bool closed_mesh, const ObjectSlicingOptions& options) {
  const Coord foot_nm = options.on_bed ? FootAt(layer, options) : 0;
  return {.closing_radius_nm = closed_mesh ? 0 : options.closing_radius_nm,
          .grow_nm = options.xy_compensation_nm - std::min<Coord>(foot_nm, 0),
          .foot_nm = std::max<Coord>(foot_nm, 0),
          .foot_min_width_nm = foot_nm > 0 ? options.elephant_foot_min_width_nm : 0,
          .widen_holes_nm = options.hole_compensation_nm};
}

MultiPolygon Edited(MultiPolygon region, const RegionEdits& edits, Coord resolution_nm) {
  if (edits == RegionEdits{} || region.empty()) return region;
  if (edits.closing_radius_nm > 0)
    region = FastOffset(FastOffset(region, edits.closing_radius_nm), -edits.closing_radius_nm);
  region = Offset(region, edits.grow_nm);
  region = ElephantFootCompensated(region, edits.foot_nm, edits.foot_min_width_nm);
  if (edits.widen_holes_nm != 0) region = WithWiderHoles(region, edits.widen_holes_nm);
  return RegionOf(Rings(region), FillRule::kNonZero, resolution_nm);
}

}  // namespace slicefarm::slicing
