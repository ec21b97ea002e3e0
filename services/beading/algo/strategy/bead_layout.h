#pragma once

#include <vector>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Beads side by side from either side of `thickness_nm` towards the middle, with what is left over
/// between the two halves: `half_widths_nm` are those of one half, outermost first; of an odd count
/// the last one is the middle bead, whole. Exactly symmetric; a left-over of one nm is what an odd
/// thickness leaves of two equal halves.
Beading LayOut(Coord thickness_nm, int count, const std::vector<Coord>& half_widths_nm);

}  // namespace slicefarm::beading
