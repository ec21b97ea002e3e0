#pragma once

#include <functional>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Function that gets one point: its position in the plane, its height above the object's bottom,
/// and the radius of the area in the plane that it represents.
using PointVisitor = std::function<void(Point point, Coord z_nm, double around_nm)>;

/// Numbers of solid layers next to open surfaces (surfaces that no other layer covers).
struct SkinLayers {
  int32_t top = 0;
  int32_t bottom = 0;
};

/// Visits points at the boundary of an object's sparse infill, at the middle heights of layers:
/// - roofs, where the sparse infill ends below each open upper surface;
/// - floors, where the sparse infill begins above each open lower surface;
/// - sides, on the outlines.
///
/// The radius of the points on roofs is so large that together they cover all of the roof. Points
/// on floors and sides are at most `step_nm` apart in both directions, and their radius is 0.
void ForEachSurfacePoint(const ObjectStack& stack, const SkinLayers& skins, Coord step_nm,
                         const PointVisitor& take);

/// Visits only points on roofs, and only below surfaces that are inclined by less than 45 degrees
/// from the horizontal.
void ForEachRoofPoint(const ObjectStack& stack, const SkinLayers& skins, Coord step_nm,
                      const PointVisitor& take);

/// Visits points everywhere inside of a stack's region, about `step_nm` apart in all directions.
void ForEachInnerPoint(const ObjectStack& stack, Coord step_nm,
                       const std::function<void(Point point, Coord z_nm)>& take);

}  // namespace slicefarm::planning
