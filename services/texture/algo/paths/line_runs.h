#pragma once

#include <vector>

#include "services/texture/algo/paths/level_lines.h"
#include "services/texture/algo/paths/work_area.h"

namespace slicefarm::texture {

/// Worked part of a line: its start, points on edges, and its end.
using Run = std::vector<SurfacePoint>;

/// Returns the parts of a line inside the area, in the line's order, without parts shorter than
/// `least_mm` in the map. The line is divided at edges of triangles and at the area's cuts; the
/// middle of each piece decides if it is inside. Cost: O(triangles that the line passes + cuts).
std::vector<Run> RunsOf(const SurfaceMap& map, const LevelLine& line, const WorkArea& area,
                        double least_mm);

}  // namespace slicefarm::texture
