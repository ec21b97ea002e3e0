#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

/// top_solid_min_thickness, bottom_solid_min_thickness: of the solid layers under (over) a surface,
/// those farthest from it that are there only to make them thick enough.
struct SkinSpare {
  int32_t layers = 0;   ///< left out one by one
  Coord enough_nm = 0;  ///< where the others are so thick

  friend bool operator==(const SkinSpare&, const SkinSpare&) = default;
};

/// Whether the layer that lies `number` layers (from 1) behind the surface is not needed: the
/// layers before it are `before_nm` high.
inline bool IsSpared(const SkinSpare& spare, int32_t solid_layers, int32_t number,
                     Coord before_nm) {
  /// Heights are sums of rounded ones.
  constexpr Coord kToleranceNm = 2'000;
  return number > solid_layers - spare.layers && before_nm + kToleranceNm >= spare.enough_nm;
}

}  // namespace slicefarm
