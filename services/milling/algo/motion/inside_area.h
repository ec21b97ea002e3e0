#pragma once

#include <Eigen/Core>
#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm::milling {

/// Returns true if a line of the tip stays in an area. Its ends may be on the outline, or 5 um
/// outside. Cost: O(n) for each of its segments.
bool InsideArea(const PolygonWithHoles& area, std::span<const Eigen::Vector2d> line_mm);

}  // namespace slicefarm::milling
