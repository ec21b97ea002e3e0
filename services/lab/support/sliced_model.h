#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::lab {

/// Slices a model that is placed on a wide bed, with the middle of its bounding box at the origin.
/// Errors: errors of reading and slicing the model.
absl::StatusOr<SlicedJob> SliceModel(const std::string& path, Coord layer_height_nm, int threads);

}  // namespace slicefarm::lab
