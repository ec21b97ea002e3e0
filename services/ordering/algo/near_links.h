#pragma once

#include <optional>

#include "common/model/path.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// Largest length of a link, in widths of the narrower bead.
///
/// A link is a short bead that joins two consecutive paths which are side by side or end to end:
/// from wall to wall, or from one piece of a wall to the next. Two paths are linked if the step is
/// shorter than this limit and crosses neither the outline nor an outer wall. Without a link the
/// flow would stop, and the nozzle would ooze during the step.
///
/// A link has kLinkFlow times a bead's flow. A loop beside the link ends earlier by the same amount
/// of plastic, so that the total does not change. If no loop is beside the link (a piece of a wall
/// ends where the next piece begins), the link fills the gap. Lines of sparse infill and loops of
/// support are joined by a full bead of their width, because their flow does not change.
///
/// Only walls, gap fill, hidden infill and loops of support are linked, and only with the same
/// tool.
inline constexpr double kMostLinkWidths = 2;
inline constexpr double kLinkFlow = 0.3;

/// End of the path that was printed last. LinkBetween may shorten the path.
struct PrintedEnd {
  Path& path;
  bool is_loop = false;  ///< true if the path is closed, or was closed before a link shortened it
};

/// Returns the link from the end of `last` to the start of `next`, or nothing if they are not
/// linked. `next` is closed if it is printed as a loop. If the link shortens one of the two loops,
/// that loop becomes an open path. `edges`: the island's outline and outer walls. `height_nm`: the
/// layer's height.
std::optional<Path> LinkBetween(PrintedEnd last, Path& next, Coord height_nm, const Barrier& edges);

}  // namespace slicefarm::ordering
