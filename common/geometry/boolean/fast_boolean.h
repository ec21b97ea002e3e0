#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm {

enum class Operation { kUnion, kIntersection, kDifference };

/// A boolean operation on regions in general position: no edge of the one passes through a corner
/// of the other, touches it, or lies along it. nullopt where that is not so, or where there is
/// doubt; Union, Intersection and Difference, which try this first, are for that. REQUIRES: islands
/// are simple and disjoint. Points of intersection are rounded to nm. Cost: see TryWindingRegion;
/// about a fifth of a sweep's.
std::optional<MultiPolygon> TryBoolean(const MultiPolygon& a, const MultiPolygon& b, Operation op);

}  // namespace slicefarm
