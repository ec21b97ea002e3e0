#pragma once

#include <optional>
#include <span>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/orientation_advice.h"
#include "common/model/scene/transform.h"

namespace slicefarm::slicing {

/// Returns the advice to rotate an object if another orientation would print better
/// (orientation.h). Returns nullopt in these cases:
/// - The current orientation is good.
/// - No orientation is stable.
/// - to_plate mirrors or shears the object, which rotation angles cannot describe.
///
/// `parts`: the object's solid parts in their current orientation. `to_plate`: scale and rotation
/// of the object that gave this orientation; the advised rotation replaces its rotation. Errors:
/// any error of SuggestOrientation.
absl::StatusOr<std::optional<OrientationAdvice>> AdviseOrientation(
    std::span<const IndexedMesh* const> parts, const Transform& to_plate,
    const CancelToken& cancel);

}  // namespace slicefarm::slicing
