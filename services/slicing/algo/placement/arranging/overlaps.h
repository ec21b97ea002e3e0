#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/layers/layer.h"
#include "services/slicing/algo/placement/arranging/footprint.h"

namespace slicefarm::slicing {

/// For each of `objects`, how many of its copies share room with a copy of another or of the same
/// object: there is a height at which the outlines of both have more than 0.001 mm2 in common.
///
/// `layers`: of the whole job, bottom up, where the parts' stacks count `objects`. Errors:
/// CANCELLED. Cost: for each two copies whose footprints overlap, a boolean operation a layer;
/// layers like the one above and copies that stand as two others do cost none.
absl::StatusOr<std::vector<int64_t>> CountOverlapping(std::span<const SlicedLayer> layers,
                                                      std::span<const Copies> objects,
                                                      const CancelToken& cancel);

}  // namespace slicefarm::slicing
