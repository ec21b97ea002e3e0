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
///   1 the paths of each section, once for all its copies (section_order.h)
///   2 stacks around several objects are first: finished paths of the plan that are as high as the
///     layer, then the plate's stacks
///   3 the copies, pass by pass, by travel from plan.entry; all stacks of a copy follow each other,
///     sorted by kind
/// `copies`: the copies of the whole job. The result does not depend on the order of sections,
/// islands and paths. Errors: REQUEST_MALFORMED for a path with fewer than two points, a wrong
/// number of widths, a tool other than 0, or settings that are in no table.
absl::StatusOr<OrderedLayer> OrderLayer(FilledLayer layer, const LayerPlan& plan,
                                        std::span<const Copy> copies,
                                        const OrderingOptions& options);

}  // namespace slicefarm::ordering
