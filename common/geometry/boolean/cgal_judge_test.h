#pragma once

#include <functional>
#include <span>
#include <string>

#include "common/geometry/boolean/fast_boolean.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

/// Differences between a region and the expected region, by exact arithmetic (CGAL's arrangements
/// of the edges of both, with winding numbers in each face). The difference consists of faces that
/// are in only one of the regions.
struct Differences {
  double area_nm2 = 0;
  /// Thickness of the thickest face: twice its area divided by its perimeter, after subtraction of
  /// 4 nm2. A boundary that rounding moves by d differs by at most d.
  double thickness_nm = 0;
  /// Largest distance from a corner of a face to the boundary of the expected region.
  double distance_nm = 0;
  /// Area in which the rings of the region have a winding number below 0 or above 1.
  double overlap_nm2 = 0;
};
/// Returns the differences as text, for failure messages.
std::string ToText(const Differences& differences);

/// Compares `got` with the exact result of `op`. A point is in a, b or got if the winding number
/// there is at least one.
Differences JudgeBoolean(const MultiPolygon& got, const MultiPolygon& a, const MultiPolygon& b,
                         Operation op);

/// Compares `got` with `want`.
Differences JudgeEqual(const MultiPolygon& got, const MultiPolygon& want);

}  // namespace slicefarm
