#pragma once

#include "common/model/layers/job_plan.h"
#include "common/model/layers/layer.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm {
struct OrderingOptions;
}  // namespace slicefarm

namespace slicefarm::ordering {

/// Returns the paths of one section in the order and direction of printing. Other sections have no
/// influence.
/// - Islands follow each other with little travel from plan.entry, towards plan.exit if there is
///   one.
/// - In each island the walls are first, contour by contour (wall_order.h). Then fills and gap fill
///   follow in one common order (fill_order.h). With infill_first: fills, walls, gap fill. With
///   unsupported_wall_last, walls over air (unsupported_walls.h) follow the fills.
///
/// The block also contains the travels between the paths (island_travels.h, outside_travels.h),
/// including the travel from plan.entry and to plan.exit. Travels from island to island are not
/// hidden.
///
/// Each path is returned once with its beads. Only its direction and, if closed, its start change.
/// The result does not depend on the order of islands and paths in `section`; only groups of fills
/// that must keep their order depend on it. REQUIRES: all paths are well-formed, and their settings
/// have a row in the tables.
PathBlock OrderSection(FilledSection section, const SectionPlan& plan,
                       const OrderingOptions& options, WorkBudget& budget);

}  // namespace slicefarm::ordering
