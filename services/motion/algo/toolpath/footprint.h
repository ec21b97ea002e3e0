#pragma once

#include <span>

#include "common/geometry/polygon.h"
#include "common/model/layers/program_summary.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Returns the convex hull of what a program prints, in plate coordinates; empty if it prints
/// nothing. Half the widest bead at the hull's corners stands out around the beads' middles.
/// Cost: O(n log n) for n moves.
Polygon FootprintOf(std::span<const Stretch> program);

/// Returns the convex hull of what a print's first layer covers, of all its copies.
Polygon FirstLayerHull(const ProgramSummary& summary);

}  // namespace slicefarm::motion
