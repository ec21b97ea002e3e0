#pragma once

#include "common/geometry/point.h"

namespace slicefarm {

/// spiral_vase: hollow layers are printed as one bead that winds up.
struct SpiralOptions {
  Coord width_nm = 0;  ///< width of the bead; 0: no spiral
  bool blends = true;  ///< turns lead over into each other: not where their skin is fuzzy

  friend bool operator==(const SpiralOptions&, const SpiralOptions&) = default;
};

}  // namespace slicefarm
