#pragma once

#include <Eigen/Core>
#include <span>

#include "common/geometry/polygon.h"

namespace slicefarm::milling {

/// Returns true if the tip remains in an area when it follows a line. The ends of the line may be
/// on the outline, or up to 5 um outside. Cost: O(n) for each segment of the line and n points of
/// the outline.
bool InsideArea(const PolygonWithHoles& area, std::span<const Eigen::Vector2d> line_mm);

}  // namespace slicefarm::milling
