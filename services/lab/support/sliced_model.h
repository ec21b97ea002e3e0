#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::lab {

/// Slices a model on a wide bed, with the middle of its bounding box at the origin. Errors: any
/// error of reading or slicing the model.
absl::StatusOr<SlicedJob> SliceModel(const std::string& path, Coord layer_height_nm, int threads);

}  // namespace slicefarm::lab
