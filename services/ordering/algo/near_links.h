#pragma once

#include <optional>

#include "common/model/path.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// Links between paths that are printed one after the other and lie side by side or end to end: the
/// step from wall to wall, and from one piece of a wall to the next.
///
/// Where the nozzle steps over by less than kMostLinkWidths widths of the narrower bead, and meets
/// neither the outline nor an outer wall, it keeps printing: the flow need not stop, and a step
/// without pressure would only ooze. A link has kLinkFlow of a bead's flow. A loop beside it ends
/// earlier by as much plastic, so that no more is laid down than without the link; where no loop is
/// beside it (pieces of walls that end where others begin), the link is what fills the gap. Between
/// lines of sparse infill and between loops of support, whose flow is even, a link is a bead as
/// wide as they are.
///
/// Only walls, gap fill, infill that is not seen and loops of support are linked, of one tool.
inline constexpr double kMostLinkWidths = 2;
inline constexpr double kLinkFlow = 0.3;

/// The end of the path printed last, which a link may have to cut off.
struct PrintedEnd {
  Path& path;
  bool is_loop = false;  ///< it is closed, or was before it lost its end
};

/// The link from the end of `last` to the start of `next`, which is closed where `next` is printed
/// as a loop; nothing where there is none. Opens the loop that it shortens. `edges`: the island's.
/// `height_nm`: of the layer.
std::optional<Path> LinkBetween(PrintedEnd last, Path& next, Coord height_nm, const Barrier& edges);

}  // namespace slicefarm::ordering
