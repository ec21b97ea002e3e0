#pragma once

#include <vector>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Bead on one side of the medial axis.
struct SideBead {
  double width = 0;     ///< width in nm; 0: a marker, the boundary of the infill's area
  double location = 0;  ///< distance from the boundary to the bead's middle, in nm

  friend bool operator==(const SideBead&, const SideBead&) = default;
};

/// Beads at a node of the medial axis: the same beads on each side of it, and one bead along it.
struct NodeBeading {
  std::vector<SideBead> sides;  ///< outermost first
  bool has_middle = false;
  double middle_width = 0;  ///< width in nm; 0 for a marker, which has no area on the axis

  friend bool operator==(const NodeBeading&, const NodeBeading&) = default;
};

/// Converts a layout across the whole thickness to the beads of a node.
NodeBeading FromBeading(const Beading& beading);

/// Returns a mix of `a` (ratio 0) and `b` (ratio 1), two layouts for a node of `radius`. `b` has
/// the same number of beads or one more. The additional bead is a middle bead that grows from
/// nothing, or it results from a middle bead that splits into two halves. So layouts that tile the
/// thickness in `a` and in `b` also tile it at each ratio between. (Upstream ends the bead and
/// leaves a hole.)
NodeBeading Between(const NodeBeading& a, const NodeBeading& b, double ratio, double radius);

/// Returns a mix of `a` (ratio 0) and `b` (ratio 1) with the beads of both. `a` is laid out for a
/// node of `radius`, `b` for a larger one. Beads that only `b` has are placed towards the middle,
/// beside the beads of `a`.
NodeBeading Blend(const NodeBeading& a, const NodeBeading& b, double ratio, double radius);

}  // namespace slicefarm::beading
