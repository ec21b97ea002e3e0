#pragma once

#include <vector>

#include "services/texture/algo/paths/level_lines.h"
#include "services/texture/algo/paths/work_area.h"

namespace slicefarm::texture {

/// A part of a line that is worked: points on edges, and its two ends.
using Run = std::vector<SurfacePoint>;

/// The parts of a line in the area, in the line's order; those shorter than `least_mm` in the map
/// are left out. Each piece between two cuts or edges is judged by its middle. Cost: O(steps +
/// cuts).
std::vector<Run> RunsOf(const SurfaceMap& map, const LevelLine& line, const WorkArea& area,
                        double least_mm);

}  // namespace slicefarm::texture
