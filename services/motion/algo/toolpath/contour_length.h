#pragma once

#include <span>
#include <vector>

#include "common/model/path.h"

namespace slicefarm::motion {

/// Returns true if a path is printed as a loop: it is closed, or has lost no more of its end than a
/// link takes that leads on from it.
bool IsLoop(const Path& path);

/// Returns for each path the length in mm that decides whether it is a small wall: of a loop its
/// own, of pieces of walls that are printed one after the other that of all together, of a link
/// between walls that of the next one. Of other paths, their own. `paths`: in the order of printing.
std::vector<double> ContourLengthsMm(std::span<const Path> paths);

}  // namespace slicefarm::motion
