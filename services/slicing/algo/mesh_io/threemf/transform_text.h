#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"

namespace slicefarm::slicing::threemf {

/// Returns OK if every entry is finite and within limits::kMaxTransformEntry, and the matrix is
/// invertible. Errors (without a location): MESH_NOT_FINITE, OUT_OF_RANGE, MESH_MALFORMED.
absl::Status CheckTransform(const Transform& transform);

/// Parses the twelve numbers of a 3MF transform, a 4x3 matrix. A point is a row vector to the left
/// of the matrix: x' = x m00 + y m10 + z m20 + m30. The translation is in units of `unit_mm`.
/// Errors: any error of CheckTransform; MESH_MALFORMED unless there are twelve numbers.
absl::StatusOr<Transform> ParseTransform(std::string_view text, double unit_mm);

/// Returns the transform that applies `inner` first and then `outer`.
Transform Composed(const Transform& outer, const Transform& inner);

}  // namespace slicefarm::slicing::threemf
