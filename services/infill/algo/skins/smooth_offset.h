#pragma once

#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/polygon.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::infill {

/// Differences below this value are noise. Edges of layers that are equal in the part differ by
/// some tens of nanometres in sections.
inline constexpr Coord kNoiseNm = 5'000;

/// Offsets a result of boolean operations without its noise. Its edges may have steps and tips of
/// noise where the operands' edges were on each other. Miters would make these tips as long as the
/// offset.
inline MultiPolygon SmoothOffset(const MultiPolygon& region, Coord distance_nm) {
  return FastOffset(Simplify(region, kNoiseNm), distance_nm);
}

}  // namespace slicefarm::infill
