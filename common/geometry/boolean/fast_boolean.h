#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm {

enum class Operation { kUnion, kIntersection, kDifference };

/// Calculates a boolean operation on regions in general position: no edge of one region passes
/// through a corner of the other region, touches it, or overlaps its edge. Returns nullopt if the
/// regions are not in general position or the result is uncertain. Use Union, Intersection and
/// Difference instead: they try this function first. REQUIRES: islands are simple and disjoint.
/// Points of intersection are rounded to nm. Cost: see TryWindingRegion; about a fifth of the cost
/// of a sweep.
std::optional<MultiPolygon> TryBoolean(const MultiPolygon& a, const MultiPolygon& b, Operation op);

}  // namespace slicefarm
