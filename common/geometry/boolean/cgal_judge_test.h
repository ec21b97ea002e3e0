#pragma once

#include <functional>
#include <span>
#include <string>

#include "common/geometry/boolean/fast_boolean.h"
#include "common/geometry/polygon.h"

namespace slicefarm {

/// How a region differs from what it should be, by exact arithmetic (CGAL's arrangements of the
/// edges of both, with winding numbers in each face). The difference falls into faces: those where
/// one has what the other has not.
struct Differences {
  double area_nm2 = 0;
  /// Of the thickest face: twice its area by its perimeter, with 4 nm2 forgiven. What rounding
  /// moves by d is d thick at most.
  double thickness_nm = 0;
  /// Of the corner of a face that lies farthest from the boundary of what should be.
  double distance_nm = 0;
  /// Of what the rings of the region wind around less than 0 times or more than once.
  double overlap_nm2 = 0;
};
std::string ToText(const Differences& differences);

/// `got` against the exact outcome of `op`. What a, b and got wind around at least once is theirs.
Differences JudgeBoolean(const MultiPolygon& got, const MultiPolygon& a, const MultiPolygon& b,
                         Operation op);

/// `got` against `want`.
Differences JudgeEqual(const MultiPolygon& got, const MultiPolygon& want);

}  // namespace slicefarm
