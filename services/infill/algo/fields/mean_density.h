#pragma once

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// What a field asks for in a region on average, from places at most 2 mm apart on lines 2 mm
/// apart. Of a region that lies between those lines: in the middle of its box. REQUIRES: the region
/// is not empty. Errors: those of CutLines. Cost: O(n log n + places).
absl::StatusOr<double> MeanDensity(const MultiPolygon& region, const LayerField& field);

}  // namespace slicefarm::infill
