#pragma once

#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/polygon.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::infill {

/// Edges of layers that lie on each other in the part do so to some tens of nanometres in sections.
/// What differs by less is noise.
inline constexpr Coord kNoiseNm = 5'000;

/// Offsets a result of boolean operations, whose edges may have steps and tips of noise where
/// operands' edges lay on each other: miters would make them as long as the offset.
inline MultiPolygon SmoothOffset(const MultiPolygon& region, Coord distance_nm) {
  return FastOffset(Simplify(region, kNoiseNm), distance_nm);
}

}  // namespace slicefarm::infill
