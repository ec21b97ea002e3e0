#pragma once

#include <cstddef>

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm {

/// Checks that `settings`, the index of region settings, is less than `rows`, and that the tool is
/// 0. Other tools are not supported yet. Errors: REQUEST_MALFORMED with the layer.
absl::Status CheckRegion(int32_t settings, int32_t tool, size_t rows, const LayerFrame& frame);

/// Checks all regions of a layer with CheckRegion.
absl::Status CheckRegions(const SlicedLayer& layer, size_t rows);

}  // namespace slicefarm
