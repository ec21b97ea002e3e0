#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/layers/layer.h"
#include "common/model/options/layer_heights.h"
#include "common/stage/slice_input.h"
#include "common/stage/stages.h"

namespace slicefarm::slicing {

/// Layer of an object, and the height at which the object is cut for it.
struct LayerPlane {
  LayerFrame frame;  ///< frame of the layer; its index counts the object's own layers
  Coord z_nm = 0;
};

/// Rules for the heights of an object's layers.
struct LayerHeights {
  Coord first_nm = 200'000;
  Coord others_nm = 200'000;
  /// ranges with a height of their own; if several contain a layer, the first is used
  std::vector<RangeInput> ranges;
  /// Height profile; if not empty, it defines all heights except the first.
  std::vector<LayerHeightAt> profile = {};
  Coord profile_above_nm = 0;  ///< the profile is evaluated at this height above a layer's bottom
};

/// Returns the layers of an object of height `top_nm` with its bottom at z = 0. The first layer has
/// its own height, all others have the height of their range. A layer belongs to the range that
/// contains its bottom, or that begins less than 35 um above its bottom.
///
/// Each layer is cut in its middle (rounded down to nm), but below the top. The last layer is the
/// highest layer with a middle at or below the top. So the print is less than half a layer lower,
/// or at most half a layer higher, than the object (the rules of PrusaSlicer).
///
/// Errors: SETTING_OUT_OF_RANGE for heights not above 0; MESH_TOO_LARGE with `limit` and `got` for
/// too many layers; NOTHING_TO_PRINT if even the first layer's middle is above the top.
absl::StatusOr<std::vector<LayerPlane>> LayerPlanes(Coord top_nm, const LayerHeights& heights);

/// Limits of the layer heights that MeetTop changes.
struct HeightLimits {
  Coord least_nm = 0;
  Coord most_nm = 0;
};

/// Changes the heights of the last five layers evenly, but not of the first layer, so that the
/// print ends at `top_nm` (precise_z_height). Heights stay in `range`, unless they already are
/// outside of it. If the range does not allow the top, the print ends as near to it as possible.
void MeetTop(Coord top_nm, const HeightLimits& range, std::vector<LayerPlane>& planes);

/// Cuts all layers but the first at `least_nm` above their bottoms, or in their middles if these
/// are lower. Then an outline encloses the area in which at least `least_nm` of the layer is inside
/// the object, as Z contouring needs.
void LowerCuts(Coord least_nm, std::vector<LayerPlane>& planes);

/// Returns layers with the tops `tops_nm`, each cut in its middle. The tops must ascend, from above
/// 0. Errors: MESH_TOO_LARGE above limits::kMaxLayers tops.
absl::StatusOr<std::vector<LayerPlane>> PlanesBelow(std::span<const Coord> tops_nm);

}  // namespace slicefarm::slicing
