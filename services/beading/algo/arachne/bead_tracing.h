#pragma once

#include <vector>

#include "common/geometry/skeleton/skeletal_graph.h"
#include "common/geometry/vector.h"
#include "services/beading/algo/arachne/node_beading.h"

namespace slicefarm::beading {

struct BeadPoint {
  Vector2 place = Vector2::Zero();
  double width = 0;  ///< nm
};

/// The middle of a bead with its width at each point.
struct BeadLine {
  int inset = 0;  ///< 0 for the outermost
  bool closed = false;
  bool is_middle = false;  ///< along the axis
  bool is_marker = false;  ///< width 0: the border of what the infill gets
  std::vector<BeadPoint> points;
};

struct TracingOptions {
  double min_middle_width_nm = 100'000;  ///< a middle bead that grows or ends is cut off here
};

/// Beads beside the medial axis are closed lines around its rings: each follows the boundary at its
/// distance from it, and where there is no room for it crosses the axis and comes back on the other
/// side. Beads along the axis are open, or rings. In the order of rings and half-edges. Cost: O(n)
/// and the points that come out.
/// Source: Kuipers et al. 2020, section 3.5; as a walk around rings, so that lines always close.
std::vector<BeadLine> TraceBeads(const SkeletalGraph& graph, const std::vector<char>& central,
                                 const std::vector<NodeBeading>& beadings,
                                 const TracingOptions& options);

}  // namespace slicefarm::beading
