#pragma once

#include <cstdint>

#include "common/model/layers/layer.h"

namespace slicefarm::bench {

/// Returns layer `index` of `layers` of a lattice of `cells` by `cells` round bars, one every 2 mm.
/// Each bar is a disc of 32 corners; its diameter changes with the height.
SlicedLayer LatticeLayer(int32_t index, int32_t layers, int cells);

}  // namespace slicefarm::bench
