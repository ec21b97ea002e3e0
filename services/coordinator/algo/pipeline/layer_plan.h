#pragma once

#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/layer.h"
#include "common/model/ordering_options.h"

namespace slicefarm::coordinator {

/// What has to be decided over the whole job before its layers become independent, from the
/// outlines alone:
///
///   entry  where the layer before ends, as far as outlines tell: its islands are visited by
///   nearest
///          neighbour. So islands are printed to and fro from layer to layer.
///   seams  `rear`: the rear-most vertex of each ring. `aligned`: a chain up the part, see
///   seam_chain.h.
///          `nearest`: none, each layer decides.
///
/// Shapes: one plan a layer. Errors: Cancelled.
/// Cost: O(points * rings of the layer below that overlap + islands^2) a layer.
absl::StatusOr<std::vector<LayerPlan>> PlanLayers(std::span<const SlicedLayer> layers,
                                                  SeamPosition seam, const CancelToken& cancel);

}  // namespace slicefarm::coordinator
