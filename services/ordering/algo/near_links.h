#pragma once

#include <optional>

#include "common/model/path.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// Largest length of a link, in widths of the narrower bead.
///
/// Links connect consecutive paths that are side by side or end to end: the step from wall to wall,
/// and from one piece of a wall to the next. The nozzle continues to print if a step is shorter
/// than this limit and crosses neither the outline nor an outer wall. The flow then need not stop;
/// a step without pressure would only ooze. A link has kLinkFlow of a bead's flow. A loop beside
/// the link ends earlier by as much plastic, so that the total amount does not change. If no loop
/// is beside the link (pieces of walls that end where other pieces begin), the link fills the gap.
/// Between lines of sparse infill and between loops of support, which have an even flow, a link is
/// a bead with their width.
///
/// Only walls, gap fill, hidden infill and loops of support are linked, and only with the same
/// tool.
inline constexpr double kMostLinkWidths = 2;
inline constexpr double kLinkFlow = 0.3;

/// End of the path that was printed last. A link may have to shorten the path.
struct PrintedEnd {
  Path& path;
  bool is_loop = false;  ///< true if the path is closed, or was closed before a link shortened it
};

/// Returns the link from the end of `last` to the start of `next`, or nothing if they are not
/// linked. `next` is closed if it is printed as a loop. If the link shortens one of the two loops,
/// this loop is opened. `edges`: the island's outline and outer walls. `height_nm`: the layer's
/// height.
std::optional<Path> LinkBetween(PrintedEnd last, Path& next, Coord height_nm, const Barrier& edges);

}  // namespace slicefarm::ordering
