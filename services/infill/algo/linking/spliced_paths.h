#pragma once

#include <vector>

#include "common/model/path.h"

namespace slicefarm::infill {

/// Takes closed paths into paths that they cross: at a crossing of two straight stretches the one
/// turns into the other, goes all the way round, and on where it left off. So lines that cross
/// become one path where rings of theirs hang together, with two blunt corners in place of one
/// crossing for each path taken in. Else the same places are passed as before, once each.
///
/// A path that nothing crosses stays. Crossings nearer than `margin_nm` to the end of a stretch do
/// not count. The first crossing in the order of the paths is taken. REQUIRES: all paths have the
/// same one width, and `margin_nm` is about that.
/// Cost: O(n k), n stretches, of which k are of closed paths, but no more than a few ten
/// milliseconds: of more paths those that were not looked at by then stay.
std::vector<Path> SplicedPaths(std::vector<Path> paths, double margin_nm);

}  // namespace slicefarm::infill
