#pragma once

#include <cstdint>

#include "common/geometry/point.h"

namespace slicefarm {

/// Solid layers that exist only to reach a minimum thickness (`top_solid_min_thickness`,
/// `bottom_solid_min_thickness`). They are the solid layers farthest from the surface. Some of them
/// may be left out.
struct ShellExtra {
  int32_t layers = 0;  ///< largest number of layers that may be left out
  /// A layer may be left out if the layers between it and the surface have at least this total
  /// height.
  Coord enough_nm = 0;

  friend bool operator==(const ShellExtra&, const ShellExtra&) = default;
};

/// Returns true if a solid layer may be left out. `solid_layers`: largest number of solid layers.
/// `number`: the layer's distance from the surface in layers, from 1. `before_nm`: total height of
/// the layers between the layer and the surface.
inline bool IsSpared(const ShellExtra& spare, int32_t solid_layers, int32_t number,
                     Coord before_nm) {
  /// Tolerance for heights, which are sums of rounded values.
  constexpr Coord kToleranceNm = 2'000;
  return number > solid_layers - spare.layers && before_nm + kToleranceNm >= spare.enough_nm;
}

}  // namespace slicefarm
