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

/// Seams at which the nozzle goes to the next layer without a retraction. `below`: the seam where
/// an island's paths continue from the layer below. `above`: the seam where the layer above
/// continues from these paths.
struct Meetings {
  std::optional<Point> below;
  std::optional<Point> above;
};

/// Travels to each path of an island. The first travel is straight and not hidden unless it comes
/// from the layer below.
struct IslandPaths {
  std::vector<Travel> travels;
  std::optional<Leave> leave;  ///< travel to the layer above
};

/// Returns the travels between the paths of one island, which are printed in the given order.
///
/// A travel is hidden if it crosses no outline, no outer wall and no printed bead of a top surface,
/// and is not too long. The limit is 5 mm to a visible bead, which would otherwise begin with a
/// gap. To other beads the options set the limit. A travel that crosses a wall makes a detour
/// inside the island if this adds at most 20 mm: a retraction takes about as much time. With
/// avoid_crossing, each travel that is too close to the walls makes a detour if a permitted one
/// exists.
///
/// The change of layers is at the start of the first inner wall that starts at the seam. An outer
/// wall is not suitable, because the outer wall above may be on either side of it. Without such an
/// inner wall, the change is at the point nearest to the seam that keeps away from the walls. The
/// walls of the other layer are unknown in either layer. So no travel to the layer above is hidden,
/// and a travel from the layer below is hidden only if it continues at the seam.
///
/// `budget`: number of lines of sight. `curled`: a travel that crosses a curled area makes a
/// detour, within the island if possible; null means that there is no curled area.
IslandPaths PathsInIsland(const PolygonWithHoles& outline, const IslandEdges& edges,
                          std::span<const Path> paths, const Meetings& meetings,
                          const TravelOptions& options, WorkBudget& budget,
                          CurlAvoidance* curled = nullptr);

}  // namespace slicefarm::ordering
