#pragma once

#include <iterator>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/model/limits.h"

namespace slicefarm::planning {

/// Returns the bed, or all that has coordinates.
inline MultiPolygon RoomOf(const MultiPolygon& bed) {
  constexpr Coord kMost = limits::kMaxCoord;
  if (!bed.empty()) return bed;
  return {{{{-kMost, -kMost}, {kMost, -kMost}, {kMost, kMost}, {-kMost, kMost}}, {}}};
}

inline void Append(MultiPolygon more, MultiPolygon& all) {
  all.insert(all.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
}

inline MultiPolygon United(const MultiPolygon& all) { return Union(all, {}); }

}  // namespace slicefarm::planning
