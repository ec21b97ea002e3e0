#pragma once

#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"
#include "common/geometry/vector.h"
#include "services/beading/algo/arachne/node_beading.h"

namespace slicefarm::beading {

/// Point on the middle line of a bead, with the bead's width.
struct BeadPoint {
  Vector2 place = Vector2::Zero();
  double width = 0;  ///< width of the bead, in nm
};

/// Middle line of a bead, with the bead's width at each point.
struct BeadLine {
  int inset = 0;  ///< number of beads between this one and the outline: 0 for the outermost
  bool closed = false;
  bool is_middle = false;  ///< true for a bead along the medial axis
  bool is_marker = false;  ///< true for a marker of width 0: the boundary of the infill's area
  std::vector<BeadPoint> points;
};

/// Options for TraceBeads.
struct TracingOptions {
  /// Smallest width of a bead along the medial axis. The bead ends where it would be narrower.
  double min_middle_width_nm = 100'000;
};

/// Returns the middle lines of all beads: first the lines beside the medial axis, sorted by inset,
/// then the lines along it. `central` is indexed by edge, `beadings` by node.
///
/// Beads beside the medial axis are closed lines inside the rings of the outline. Each line keeps
/// its distance from the outline. Where the region is too narrow for this distance, the line
/// crosses the axis and returns on the other side. Beads along the axis are open lines or rings.
/// Cost: O(n) plus the number of resulting points, n edges.
///
/// Source: Kuipers et al. 2020, section 3.5. Unlike there, lines follow the rings, so they always
/// close.
std::vector<BeadLine> TraceBeads(const SkeletalGraph& graph, const std::vector<char>& central,
                                 const std::vector<NodeBeading>& beadings,
                                 const TracingOptions& options);

}  // namespace slicefarm::beading
