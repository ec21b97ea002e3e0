#pragma once

#include <vector>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Returns beads side by side from both sides of `thickness_nm` towards the middle. The remaining
/// thickness is left over between the two halves.
///
/// `half_widths_nm`: widths of one half, outermost first. If the count is odd, the last one is the
/// whole middle bead. The result is exactly symmetric. A left-over of one nm is the remainder of an
/// odd thickness with two equal halves.
Beading LayOut(Coord thickness_nm, int count, const std::vector<Coord>& half_widths_nm);

}  // namespace slicefarm::beading
