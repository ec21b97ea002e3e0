#pragma once

#include <vector>

#include "services/beading/algo/strategy/beading_strategy.h"

namespace slicefarm::beading {

/// Lays out `count` beads across `thickness_nm`: one half from each side towards the middle.
/// Thickness that the beads do not cover is left over between the two halves.
///
/// `half_widths_nm`: widths of one half, outermost first. If `count` is odd, the last entry is the
/// width of the whole middle bead. The result is exactly symmetric. With two equal halves and an
/// odd thickness, 1 nm is left over.
Beading LayOut(Coord thickness_nm, int count, const std::vector<Coord>& half_widths_nm);

}  // namespace slicefarm::beading
