#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/model/options/layer_heights.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"

namespace slicefarm::slicing {

/// A layer of an object and the height at which the object is cut for it.
struct LayerPlane {
  LayerFrame frame;  ///< its index is that of the object's own layers
  Coord z_nm = 0;
};

/// How high the layers of an object are.
struct LayerHeights {
  Coord first_nm = 200'000;
  Coord others_nm = 200'000;
  std::vector<RangeInput> ranges;  ///< heights of their own; the first one that holds counts
  /// If there is one, it says all heights but the first.
  std::vector<LayerHeightAt> profile = {};
  Coord profile_above_nm = 0;  ///< how far above its bottom a layer looks into the profile
};

/// Layers for an object of height `top_nm` that stands on 0: the first has its own height, all above
/// that of their range. A layer belongs to the range that its bottom lies in, or less than 35 um
/// below. Each is cut in its middle (rounded down to nm), but below the top. The last layer is the
/// last whose middle lies no higher than the top, so the print is less than half a layer lower or at
/// most half a layer higher than the object (the rules of PrusaSlicer). Errors: SETTING_OUT_OF_RANGE for heights not above 0; MESH_TOO_LARGE with
/// `limit`, `got` for too many layers; NOTHING_TO_PRINT if even the first layer's middle lies above
/// the top.
absl::StatusOr<std::vector<LayerPlane>> LayerPlanes(Coord top_nm, const LayerHeights& heights);

/// Layers with these tops, which ascend from above 0. Errors: MESH_TOO_LARGE.
absl::StatusOr<std::vector<LayerPlane>> PlanesBelow(std::span<const Coord> tops_nm);

}  // namespace slicefarm::slicing
