#pragma once

#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/polygon.h"
#include "common/geometry/rings/simplify.h"

namespace slicefarm::infill {

/// Differences below this value are noise. If layers of a part have the same edge, its position in
/// their sections differs by some tens of nanometres.
inline constexpr Coord kNoiseNm = 5'000;

/// Offsets a result of boolean operations without its noise. Where edges of the operands coincided,
/// the result may have tiny steps and tips. Miters would make these tips as long as the offset.
inline MultiPolygon SmoothOffset(const MultiPolygon& region, Coord distance_nm) {
  return FastOffset(Simplify(region, kNoiseNm), distance_nm);
}

}  // namespace slicefarm::infill
