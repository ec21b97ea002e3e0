#pragma once

#include "absl/status/statusor.h"
#include "common/model/layer.h"
#include "common/model/ordering_options.h"

namespace slicefarm::ordering {

/// The paths of a layer in the order and direction of printing:
///   1 islands by travel from plan.entry
///   2 in an island the walls, contour by contour (wall_order.h), then fills and gap fill in one
///     order (fill_order.h); with infill_first: fills, walls, gap fill
/// Every path comes out once and keeps its beads; only its direction and, if closed, its start
/// change. Does not depend on the order of islands and paths in `layer`, but for that within groups
/// that keep it. Errors: InvalidArgument for a path of fewer than two points or with a wrong number
/// of widths.
absl::StatusOr<OrderedLayer> OrderLayer(FilledLayer layer, const LayerPlan& plan,
                                        const OrderingOptions& options);

}  // namespace slicefarm::ordering
