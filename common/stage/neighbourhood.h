#pragma once

#include <span>

#include "common/model/layers/layer.h"

namespace slicefarm {

/// A stretch of consecutive layers of a job: the layers to work on and their halo.
struct Neighbourhood {
  LayerRange range;                     ///< to work on
  std::span<const SlicedLayer> layers;  ///< consecutive, the range among them
};

}  // namespace slicefarm
