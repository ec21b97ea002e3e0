#pragma once

#include <span>

#include "absl/status/statusor.h"
#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"

namespace slicefarm {
struct OrderingOptions;
}  // namespace slicefarm

namespace slicefarm::ordering {

/// Returns a layer in the order of printing:
/// - The paths of each section are ordered once for all its copies (section_order.h).
/// - Finished paths of the plan that are as high as the layer are printed first, then the stacks
///   that belong to no single object.
/// - The copies follow, pass by pass. Within a pass, the order of copies has little travel,
///   beginning at plan.entry. All stacks of a copy follow each other, sorted by kind.
///
/// `copies`: the copies of the whole job. The result does not depend on the order of sections,
/// islands and paths. Errors: REQUEST_MALFORMED for a path with fewer than two points, a wrong
/// number of widths, a tool other than 0, or settings that are in no table.
absl::StatusOr<OrderedLayer> OrderLayer(FilledLayer layer, const LayerPlan& plan,
                                        std::span<const Copy> copies,
                                        const OrderingOptions& options);

}  // namespace slicefarm::ordering
