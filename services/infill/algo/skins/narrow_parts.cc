#include "services/infill/algo/skins/narrow_parts.h"

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/clean_offset.h"

namespace slicefarm::infill {

SolidParts PartByWidth(const MultiPolygon& solid, Coord narrow_nm, Coord width_nm) {
  const Coord half = narrow_nm / 2;
  const MultiPolygon core = FastOffset(solid, -half);
  const MultiPolygon beside = core.empty() ? solid : Difference(solid, FastOffset(core, half));
  SolidParts parts;
  parts.narrow = Intersection(FastOffset(FastOffset(beside, -width_nm / 2), width_nm / 2), solid);
  if (parts.narrow.empty()) {
    parts.wide = solid;
  } else {
    parts.wide = Difference(solid, parts.narrow);
  }
  return parts;
}

}  // namespace slicefarm::infill
