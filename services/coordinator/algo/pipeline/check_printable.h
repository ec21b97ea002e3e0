#pragma once

#include <span>

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

/// Checks that at least one layer has an outline. Errors: NOTHING_TO_PRINT if no layer has one.
absl::Status CheckPrintable(std::span<const SlicedLayer> layers);

}  // namespace slicefarm::coordinator
