#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// A part of a segment, by the distance from its first point.
struct SegmentPart {
  double from_nm = 0;
  double to_nm = 0;
};

/// The part of ab beside which cd runs: at an angle of 20 degrees at most, and nearer than
/// `near_nm`.
std::optional<SegmentPart> PartBeside(Point a, Point b, Point c, Point d, double near_nm);

}  // namespace slicefarm::infill
