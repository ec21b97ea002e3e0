#pragma once

#include <vector>

#include "common/model/path.h"

namespace slicefarm::infill {

/// Inserts closed paths into paths that they cross. At a crossing of two straight segments, the
/// outer path enters the closed path, follows it completely, and then continues. Crossing lines
/// therefore become one path if their rings are connected. At the crossing, both corners are cut
/// off so that the beads do not meet there. All other points are in the result exactly once.
///
/// A path without crossings does not change. A crossing nearer than `margin_nm` to the end of a
/// segment does not count. The first crossing in the order of the paths is used. REQUIRES: all
/// paths have the same single width, and `margin_nm` is about this width. Cost: O(p log p) for p
/// paths, and the pairs of segments of paths near each other. After 4 million compared pairs of
/// segments (a few tens of milliseconds) the remaining paths do not change.
std::vector<Path> SplicedPaths(std::vector<Path> paths, double margin_nm);

}  // namespace slicefarm::infill
