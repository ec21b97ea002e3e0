#pragma once

#include <iterator>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/model/limits.h"

namespace slicefarm::planning {

/// Returns the area that may be printed on: the bed, or if `bed` is empty, a square that contains
/// all valid coordinates.
inline MultiPolygon PrintableArea(const MultiPolygon& bed) {
  constexpr Coord kMost = limits::kMaxCoord;
  if (!bed.empty()) return bed;
  return {{{{-kMost, -kMost}, {kMost, -kMost}, {kMost, kMost}, {-kMost, kMost}}, {}}};
}

/// Appends the polygons of `more` to `all`.
inline void Append(MultiPolygon more, MultiPolygon& all) {
  all.insert(all.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
}

/// Returns the union of polygons that may overlap.
inline MultiPolygon United(const MultiPolygon& all) { return Union(all, {}); }

}  // namespace slicefarm::planning
