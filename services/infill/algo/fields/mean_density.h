#pragma once

#include "absl/status/statusor.h"
#include "common/geometry/polygon.h"
#include "services/infill/algo/fields/layer_field.h"

namespace slicefarm::infill {

/// Returns the mean density of a field in a region, from samples on parallel lines 2 mm apart. The
/// samples on a line are at most 2 mm apart. If no line meets the region, returns the density in
/// the middle of its bounding box. REQUIRES: the region is not empty. Errors: REQUEST_TOO_LARGE
/// (see CutLines). Cost: O(n log n + samples), n points of the region.
absl::StatusOr<double> MeanDensity(const MultiPolygon& region, const LayerField& field);

}  // namespace slicefarm::infill
