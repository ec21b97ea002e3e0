#pragma once

#include <span>

#include "common/geometry/polygon.h"
#include "common/model/layers/program_summary.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm::motion {

/// Returns the convex hull of a program's beads, in plate coordinates; empty if it prints nothing.
/// The hull of the centre lines is grown by half the width of the widest bead. Cost: O(n log n) for
/// n moves.
Polygon FootprintOf(std::span<const MoveSpan> program);

/// Returns the convex hull of a print's first layer, with all its copies.
Polygon FirstLayerHull(const ProgramSummary& summary);

}  // namespace slicefarm::motion
