#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/model/layers/layer.h"
#include "services/slicing/algo/placement/arranging/footprint.h"

namespace slicefarm::slicing {

/// Returns for each of `objects` the number of its copies that overlap with a copy of the same or
/// another object. Two copies overlap if their outlines have more than 0.001 mm2 in common at some
/// height.
///
/// `layers`: all layers of the job, bottom up; their stacks are indices into `objects`. Errors:
/// CANCELLED. Cost: one boolean operation per layer for each pair of copies with overlapping
/// footprints. Layers equal to the layer above, and pairs with an already tested relative position,
/// cost nothing.
absl::StatusOr<std::vector<int64_t>> CountOverlapping(std::span<const SlicedLayer> layers,
                                                      std::span<const Copies> objects,
                                                      const CancelToken& cancel);

}  // namespace slicefarm::slicing
