#pragma once

#include <string>
#include <vector>

#include "common/model/path.h"

namespace slicefarm::lab {

/// Paths as text, a line each: number of points, then x and y of each in mm. A closed path ends
/// with its first point once more.
std::string PrintFill(const std::vector<Path>& paths);

}  // namespace slicefarm::lab
