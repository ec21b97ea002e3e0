#pragma once

#include <span>
#include <vector>

#include "common/model/path.h"

namespace slicefarm::motion {

/// Returns true if a path is printed as a loop: it is closed, or its ends are at most a width apart
/// because a link follows it.
bool IsLoop(const Path& path);

/// Returns for each path the length in mm that decides whether small_perimeter_speed applies.
/// `paths` are in the order of printing.
/// - Loop: its own length.
/// - Connected pieces of walls: their total length.
/// - Link between walls: the length of the next wall.
/// - Any other path: its own length.
std::vector<double> ContourLengthsMm(std::span<const Path> paths);

}  // namespace slicefarm::motion
