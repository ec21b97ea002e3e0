#pragma once

#include <string>
#include <vector>

#include "common/model/path.h"

namespace slicefarm::lab {

/// Returns paths as text, one per line: number of points, then x and y of each point in mm. A
/// closed path repeats its first point at the end.
std::string PrintFill(const std::vector<Path>& paths);

}  // namespace slicefarm::lab
