#pragma once

#include <vector>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// A bead on one side of the medial axis.
struct SideBead {
  double width = 0;     ///< nm; 0: a marker, the border of what the infill gets
  double location = 0;  ///< nm from the boundary to its middle

  friend bool operator==(const SideBead&, const SideBead&) = default;
};

/// The beads at a node of the medial axis: the same ones on every side of it, and one that runs
/// along it.
struct NodeBeading {
  std::vector<SideBead> sides;  ///< outermost first
  bool has_middle = false;
  double middle_width = 0;  ///< nm; 0 for a marker, which along the axis borders on nothing

  friend bool operator==(const NodeBeading&, const NodeBeading&) = default;
};

NodeBeading FromBeading(const Beading& beading);

/// Goes over from `a` (ratio 0) to `b` (ratio 1), two layouts for a node of `radius` of which `b`
/// has as many beads or one more. A middle bead grows from nothing, or splits into two halves, so
/// that what tiles the thickness in `a` and in `b` tiles it all the way between. (Upstream lets the
/// bead end, and leaves a hole.)
NodeBeading Between(const NodeBeading& a, const NodeBeading& b, double ratio, double radius);

/// Goes over from `a`, laid out for a node of `radius`, to `b` in the beads that both have; those
/// that only `b` has lie beside them.
NodeBeading Blend(const NodeBeading& a, const NodeBeading& b, double ratio, double radius);

}  // namespace slicefarm::beading
