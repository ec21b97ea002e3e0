#pragma once

#include <cstddef>

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm {

/// REQUEST_MALFORMED, with the layer, unless a row of settings is one of a table of `rows`, and the
/// tool is 0: others are refused until tools exist.
absl::Status CheckRegion(int32_t settings, int32_t tool, size_t rows, const LayerFrame& frame);

/// The same for all regions of a layer.
absl::Status CheckRegions(const SlicedLayer& layer, size_t rows);

}  // namespace slicefarm
