#pragma once

#include <optional>
#include <span>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/scene/mesh.h"
#include "common/model/scene/orientation_advice.h"
#include "common/model/scene/transform.h"

namespace slicefarm::slicing {

/// Whether an object would print better another way round (orientation.h), and how. Nothing if it
/// lies well, no way is stable, or to_plate mirrors or shears it: no angles say that.
///
/// `parts`: its solid parts as they lie. `to_plate`: how the object was scaled and turned for that;
/// the advice is the rotation to give instead of the one in it. Errors: those of
/// SuggestOrientation.
absl::StatusOr<std::optional<OrientationAdvice>> AdviseOrientation(
    std::span<const IndexedMesh* const> parts, const Transform& to_plate,
    const CancelToken& cancel);

}  // namespace slicefarm::slicing
