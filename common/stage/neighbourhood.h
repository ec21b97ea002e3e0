#pragma once

#include <span>

#include "common/model/layers/layer.h"

namespace slicefarm {

/// Consecutive layers of a job: the layers to work on, and their halo of layers below and above.
struct Neighbourhood {
  LayerRange range;                     ///< layers to work on
  std::span<const SlicedLayer> layers;  ///< consecutive layers that include `range`
};

}  // namespace slicefarm
