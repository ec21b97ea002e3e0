#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "common/model/layer.h"
#include "common/model/slicing_options.h"

namespace slicefarm::slicing {

/// A layer and the height at which the part is cut for it.
struct LayerPlane {
  LayerFrame frame;
  Coord z_nm = 0;
};

/// Layers for a part of height `top_nm` that stands on 0: the first has its own height, all above
/// layer_height. Each is cut in its middle (rounded down to nm). The last layer is the last whose
/// middle lies below the top, so the print is at most half a layer lower or higher than the part
/// (the rule of PrusaSlicer). Errors: SETTING_OUT_OF_RANGE for heights not above 0; MESH_TOO_LARGE
/// with `limit`, `got` for too many layers; NOTHING_TO_PRINT if not even the first layer's middle
/// lies below the top.
absl::StatusOr<std::vector<LayerPlane>> LayerPlanes(Coord top_nm, const SlicingOptions& options);

}  // namespace slicefarm::slicing
