#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/model/layers/layer.h"
#include "services/ordering/algo/comb/curled_ways.h"
#include "services/ordering/algo/comb/island_edges.h"

namespace slicefarm {
struct TravelOptions;
}  // namespace slicefarm

namespace slicefarm::ordering {

/// The seams at which an island's paths go on from the layer below, and at which the layer above
/// goes on from them, where layers meet with the filament ready.
struct Meetings {
  std::optional<Point> below;
  std::optional<Point> above;
};

/// One travel to each path; the first one is straight and in sight but where it comes from the
/// layer below.
struct IslandWays {
  std::vector<Travel> travels;
  std::optional<Leave> leave;  ///< to the layer above
};

/// The ways between the paths of one island, which are printed in this order.
///
/// A way is hidden if it crosses no outline, no outer wall and no printed bead of a top surface,
/// and is not too long: 5 mm to a visible bead, which would begin with a gap, else as the options
/// say.
/// A way that crosses a wall goes round inside the island where that is no longer than 20 mm more:
/// a retraction takes about as much time. With avoid_crossing each way that is not clear of the
/// walls goes round if a detour that is allowed leads there.
/// Layers meet where the first inner wall starts that starts at the seam: the outer wall above may
/// lie on either side of the one below. Where none does, they meet at the place nearest to the seam
/// that keeps off the walls. Neither layer knows the other one's walls: no way to the layer above
/// is hidden, and one from the layer below only where it leads on at the seam. `budget`: for lines
/// of sight. `curled`: a way that meets it goes round, within the island if it can; null: nothing
/// has curled up.
IslandWays WaysInIsland(const PolygonWithHoles& outline, const IslandEdges& edges,
                        std::span<const Path> paths, const Meetings& meetings,
                        const TravelOptions& options, WorkBudget& budget,
                        CurledWays* curled = nullptr);

}  // namespace slicefarm::ordering
