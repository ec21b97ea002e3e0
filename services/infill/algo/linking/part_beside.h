#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Part of a segment, given by distances from its first point.
struct SegmentPart {
  double from_nm = 0;
  double to_nm = 0;
};

/// Returns the part of segment ab that has segment cd beside it, at an angle of at most 20 degrees
/// and nearer than `near_nm`; nullopt if there is none.
std::optional<SegmentPart> PartBeside(Point a, Point b, Point c, Point d, double near_nm);

}  // namespace slicefarm::infill
