#pragma once

#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm {
struct OrderingOptions;
}  // namespace slicefarm

namespace slicefarm::ordering {

/// The paths of one section in the order and direction of printing, whatever stands around it:
///   1 islands by travel from plan.entry, towards plan.exit if there is one
///   2 in an island the walls, contour by contour (wall_order.h), then fills and gap fill in one
///     order (fill_order.h); with infill_first: fills, walls, gap fill
/// and the ways between them (island_travels.h, outside_travels.h), in from plan.entry and on to
/// plan.exit included; from island to island they are in sight. Every path comes out once and keeps
/// its beads; only its direction and, if closed, its start change. Does not depend on the order of
/// islands and paths in `section`, but for that within groups that keep it. REQUIRES: all paths are
/// well-formed, and their settings have a row.
PathBlock OrderSection(FilledSection section, const SectionPlan& plan,
                       const OrderingOptions& options, WorkBudget& budget);

}  // namespace slicefarm::ordering
