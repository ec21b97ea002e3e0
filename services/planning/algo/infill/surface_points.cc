#include "services/planning/algo/infill/surface_points.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/planning/algo/infill/grid_points.h"

namespace slicefarm::planning {
namespace {

void AlongEdges(const MultiPolygon& outline, Coord z_nm, Coord step_nm, const TakePoint& take) {
  ForEachRing(outline, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      const auto steps = static_cast<int64_t>(
          std::ceil(std::max(1.0, Distance(a, b) / static_cast<double>(step_nm))));
      for (int64_t k = 0; k < steps; ++k)
        take({a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps}, z_nm);
    }
  });
}

/// An area that may be narrower than the step: its edge, and a grid within.
void Over(const MultiPolygon& area, Coord z_nm, Coord step_nm, const TakePoint& take) {
  AlongEdges(area, z_nm, step_nm, take);
  for (const Point p : GridPoints(area, step_nm)) take(p, z_nm);
}

/// What of a layer is open towards the next one, `nearer_nm` away from what covers it.
MultiPolygon Open(const ObjectStack& stack, size_t layer, int step, Coord nearer_nm) {
  const int64_t next = static_cast<int64_t>(layer) + step;
  const MultiPolygon& whole = stack[layer].whole;
  if (next < 0 || next >= std::ssize(stack)) return whole;
  const MultiPolygon& cover = stack[static_cast<size_t>(next)].whole;
  if (cover == whole) return {};
  return Difference(whole, nearer_nm > 0 ? FastOffset(cover, nearer_nm) : cover);
}

}  // namespace

void ForEachSurfacePoint(const ObjectStack& stack, Coord step_nm, const TakePoint& take) {
  for (size_t i = 0; i < stack.size(); ++i) {
    const Coord top_nm = stack[i].z_nm, bottom_nm = top_nm - stack[i].height_nm;
    AlongEdges(stack[i].whole, top_nm - stack[i].height_nm / 2, step_nm, take);
    Over(Open(stack, i, 1, 0), top_nm, step_nm, take);
    Over(Open(stack, i, -1, 0), bottom_nm, step_nm, take);
  }
}

void ForEachTopPoint(const ObjectStack& stack, Coord step_nm, const TakePoint& take) {
  for (size_t i = 0; i < stack.size(); ++i)
    Over(Open(stack, i, 1, stack[i].height_nm), stack[i].z_nm, step_nm, take);
}

}  // namespace slicefarm::planning
