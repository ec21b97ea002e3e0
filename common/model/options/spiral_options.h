#pragma once

#include "common/geometry/point.h"

namespace slicefarm {

/// Options of spiral_vase: hollow layers are printed as one continuous rising bead.
struct SpiralOptions {
  Coord width_nm = 0;  ///< width of the bead; 0: no spiral
  /// True: each turn changes gradually from the outline of the layer below to the outline of its
  /// own layer. False: each turn follows the outline of its own layer, as with fuzzy skin.
  bool blends = true;

  friend bool operator==(const SpiralOptions&, const SpiralOptions&) = default;
};

}  // namespace slicefarm
