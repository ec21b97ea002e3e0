#pragma once

#include <span>

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

/// Errors: NOTHING_TO_PRINT if no layer has an outline.
absl::Status CheckPrintable(std::span<const SlicedLayer> layers);

}  // namespace slicefarm::coordinator
