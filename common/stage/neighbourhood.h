#pragma once

#include <span>

#include "common/model/layers/layer.h"

namespace slicefarm {

/// Layers to work on (`range`), with their halo: further layers below and above that the stage
/// reads.
struct Neighbourhood {
  LayerRange range;                     ///< layers to work on
  std::span<const SlicedLayer> layers;  ///< consecutive layers of the job: `range` and its halo
};

}  // namespace slicefarm
