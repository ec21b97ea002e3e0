#pragma once

#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/polygon.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::infill {

/// Differences below this value are noise. If two layers of a part have the same edge, the
/// positions of this edge in their sections differ by some tens of nanometres.
inline constexpr Coord kNoiseNm = 5'000;

/// Offsets a result of boolean operations after removing its noise. Where edges of the operands
/// coincided, the result may have tiny steps and tips. With miters, an offset would make each tip
/// as long as the offset distance.
inline MultiPolygon SmoothOffset(const MultiPolygon& region, Coord distance_nm) {
  return FastOffset(Simplify(region, kNoiseNm), distance_nm);
}

}  // namespace slicefarm::infill
