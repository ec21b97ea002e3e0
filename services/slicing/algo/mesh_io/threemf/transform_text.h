#pragma once

#include <string_view>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/scene/scene.h"

namespace slicefarm::slicing::threemf {

/// OK if every entry is finite and within limits::kMaxTransformEntry, and the matrix can be
/// inverted. Errors (without a place): MESH_NOT_FINITE, OUT_OF_RANGE, MESH_MALFORMED.
absl::Status CheckTransform(const Transform& transform);

/// The twelve numbers of a 3MF transform, which stand for a 4x3 matrix that points are multiplied
/// with from the left: x' = x m00 + y m10 + z m20 + m30. The shift is in units of `unit_mm`.
/// Errors: those of CheckTransform; MESH_MALFORMED unless there are twelve numbers.
absl::StatusOr<Transform> ParseTransform(std::string_view text, double unit_mm);

/// `outer` after `inner`.
Transform Composed(const Transform& outer, const Transform& inner);

}  // namespace slicefarm::slicing::threemf
