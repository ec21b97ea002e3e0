#pragma once

#include <vector>

#include "common/model/path.h"

namespace slicefarm::infill {

/// Inserts closed paths into paths that they cross. At a crossing of two straight segments, the
/// path turns into the closed path, follows it completely, and then continues. Crossing lines
/// therefore become one path if their rings are connected. Each inserted path replaces one crossing
/// by two blunt corners. All other points are passed once, as before.
///
/// A path without crossings does not change. A crossing nearer than `margin_nm` to the end of a
/// segment does not count. The first crossing in the order of the paths is used. REQUIRES: all
/// paths have the same single width, and `margin_nm` is about this width. Cost: O(n k), n segments,
/// of which k belong to closed paths, but at most a few tens of milliseconds. If the limit is
/// reached, the remaining paths do not change.
std::vector<Path> SplicedPaths(std::vector<Path> paths, double margin_nm);

}  // namespace slicefarm::infill
