#include "services/planning/algo/infill/surface_points.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/planning/algo/infill/grid_points.h"

namespace slicefarm::planning {
namespace {

/// Divisor of the step for the grid of roofs. The radius of the points follows from this finer
/// grid.
constexpr Coord kRoofSteps = 4;

template <class Take>
void AlongEdges(const MultiPolygon& outline, Coord step_nm, const Take& take) {
  ForEachRing(outline, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      const auto steps = static_cast<int64_t>(
          std::ceil(std::max(1.0, Distance(a, b) / static_cast<double>(step_nm))));
      for (int64_t k = 0; k < steps; ++k)
        take({a.x + (b.x - a.x) * k / steps, a.y + (b.y - a.y) * k / steps});
    }
  });
}

/// Returns the middle of a layer's height, where the layer's lines are computed.
Coord MiddleOf(const StackLayer& layer) { return layer.z_nm - layer.height_nm / 2; }

/// Visits points of an area that may be narrower than the step: points along its boundary, and a
/// grid inside.
template <class Take>
void Over(const MultiPolygon& area, Coord step_nm, const Take& take) {
  AlongEdges(area, step_nm, take);
  for (const Point p : GridPoints(area, step_nm)) take(p);
}

/// Returns the part of a layer that the next layer (`step` 1: above, -1: below) does not cover.
/// With `nearer_nm` > 0 the result keeps this distance from the covered part.
MultiPolygon Open(const ObjectStack& stack, size_t layer, int step, Coord nearer_nm) {
  const int64_t next = static_cast<int64_t>(layer) + step;
  const MultiPolygon& whole = stack[layer].whole;
  if (next < 0 || next >= std::ssize(stack)) return whole;
  const MultiPolygon& cover = stack[static_cast<size_t>(next)].whole;
  if (cover == whole) return {};
  return Difference(whole, nearer_nm > 0 ? FastOffset(cover, nearer_nm) : cover);
}

/// Visits the open part of a layer as points of a roof, at the height where the sparse infill below
/// it ends. The radius of the points is 1.21 grid steps: each point of the roof is within 0.71
/// steps of a grid point, or near the boundary within half a step of a visited boundary point.
void RoofUnder(const ObjectStack& stack, const SkinLayers& skins, size_t layer,
               const MultiPolygon& open, Coord step_nm, const PointVisitor& take) {
  const auto top = static_cast<size_t>(skins.top);
  if (layer < top) return;
  const Coord fine_nm = std::max<Coord>(1, step_nm / kRoofSteps);
  const double around = 1.21 * static_cast<double>(fine_nm);
  const Coord z = MiddleOf(stack[layer - top]);
  Over(open, fine_nm, [&](Point p) { take(p, z, around); });
}

}  // namespace

void ForEachSurfacePoint(const ObjectStack& stack, const SkinLayers& skins, Coord step_nm,
                         const PointVisitor& take) {
  const auto bottom = static_cast<size_t>(skins.bottom);
  for (size_t i = 0; i < stack.size(); ++i) {
    const auto at = [&](Coord z_nm) { return [&take, z_nm](Point p) { take(p, z_nm, 0); }; };
    AlongEdges(stack[i].whole, step_nm, at(MiddleOf(stack[i])));
    if (i + bottom < stack.size())
      Over(Open(stack, i, -1, 0), step_nm, at(MiddleOf(stack[i + bottom])));
    RoofUnder(stack, skins, i, Open(stack, i, 1, 0), step_nm, take);
  }
}

void ForEachRoofPoint(const ObjectStack& stack, const SkinLayers& skins, Coord step_nm,
                      const PointVisitor& take) {
  for (size_t i = 0; i < stack.size(); ++i)
    RoofUnder(stack, skins, i, Open(stack, i, 1, stack[i].height_nm), step_nm, take);
}

void ForEachInnerPoint(const ObjectStack& stack, Coord step_nm,
                       const std::function<void(Point point, Coord z_nm)>& take) {
  Coord next = 0;
  for (const StackLayer& layer : stack) {
    const Coord z = MiddleOf(layer);
    if (z < next) continue;
    for (const Point p : GridPoints(layer.region, step_nm)) take(p, z);
    next = z + step_nm;
  }
}

}  // namespace slicefarm::planning
