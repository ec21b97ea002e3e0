#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/model/layers/layer.h"
#include "services/ordering/algo/comb/curl_avoidance.h"
#include "services/ordering/algo/comb/island_edges.h"

namespace slicefarm {
struct TravelOptions;
}  // namespace slicefarm

namespace slicefarm::ordering {

/// Seams at which the nozzle changes the layer without a retraction.
struct Meetings {
  std::optional<Point> below;
  std::optional<Point> above;
};

/// Travels to each path of an island, indexed by path. The first travel is straight and not hidden
/// unless the nozzle comes from the layer below.
struct IslandPaths {
  std::vector<Travel> travels;
  std::optional<ExitTravel> exit_travel;  ///< travel to the layer above
};

/// Returns the travels between the paths of one island, which are printed in the given order.
///
/// A hidden travel needs no retraction. A travel is hidden if it is short and crosses no outline,
/// no outer wall and no printed bead of a top surface. To a visible bead, the length limit is 5 mm,
/// because a longer travel would leave a gap at the bead's start. To other beads, the options set
/// the limit. A travel that crosses a wall makes a detour inside the island if this adds at most 20
/// mm: a retraction takes about as much time. With avoid_crossing, each travel that is too close to
/// the walls makes a detour if a permitted one exists.
///
/// The nozzle changes the layer at the start of the first inner wall that starts at the seam. An
/// outer wall is not suitable, because the outer wall above may be on either side of it. Without
/// such an inner wall, the nozzle changes at the point nearest to the seam that keeps away from the
/// walls. Each layer is ordered without the walls of the next one. So no travel to the layer above
/// is hidden, and a travel from the layer below is hidden only if it continues at the seam.
///
/// `meetings.below`: seam where these paths continue from the layer below. `meetings.above`: seam
/// where the layer above continues. `budget`: number of lines of sight. `curled`: a travel that
/// crosses a curled area makes a detour, within the island if possible; null means that there is no
/// curled area.
IslandPaths PathsInIsland(const PolygonWithHoles& outline, const IslandEdges& edges,
                          std::span<const Path> paths, const Meetings& meetings,
                          const TravelOptions& options, WorkBudget& budget,
                          CurlAvoidance* curled = nullptr);

}  // namespace slicefarm::ordering
