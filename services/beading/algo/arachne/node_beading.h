#pragma once

#include <vector>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Bead on one side of the medial axis.
struct SideBead {
  double width = 0;     ///< width in nm; 0: a marker, the boundary of the infill's area
  double location = 0;  ///< distance from the outline to the bead's middle line, in nm

  friend bool operator==(const SideBead&, const SideBead&) = default;
};

/// Beads at a node of the medial axis. Both sides of the axis have the beads in `sides`. There may
/// also be one bead along the axis.
struct NodeBeading {
  std::vector<SideBead> sides;  ///< outermost first
  bool has_middle = false;
  double middle_width = 0;  ///< width in nm; 0 for a marker, or if `has_middle` is false

  friend bool operator==(const NodeBeading&, const NodeBeading&) = default;
};

/// Converts a layout across the whole thickness (beading_strategy.h) to the beads of a node.
NodeBeading FromBeading(const Beading& beading);

/// Returns the beads at a position within a transition. `a` (ratio 0) and `b` (ratio 1) are layouts
/// for the same node; `radius` is its radius in nm. `b` has the same number of beads as `a`, or one
/// more. The additional bead is a middle bead that grows from width 0, or the middle bead of `a` is
/// split into two halves. So if `a` and `b` tile the thickness, all layouts between them do.
/// (Upstream ends the bead and leaves a hole.)
NodeBeading Between(const NodeBeading& a, const NodeBeading& b, double ratio, double radius);

/// Returns a mix of `a` (ratio 0) and `b` (ratio 1) with all beads of `b`. `a` is laid out for a
/// node with `radius` (in nm), `b` for a node with a larger radius. Beads that only `b` has extend
/// from the innermost bead of the mix towards the middle.
NodeBeading Blend(const NodeBeading& a, const NodeBeading& b, double ratio, double radius);

}  // namespace slicefarm::beading
