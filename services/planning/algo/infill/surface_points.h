#pragma once

#include <functional>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Callback for one point: its position in the plane, its height above the object's bottom, and its
/// radius in the plane.
using TakePlace = std::function<void(Point place, Coord z_nm, double around_nm)>;

/// Numbers of solid layers next to open surfaces.
struct SkinLayers {
  int32_t top = 0;
  int32_t bottom = 0;
};

/// Visits points at the boundary of an object's sparse infill, in the middle of the layers'
/// heights:
/// - roofs, one top skin below each open upper surface;
/// - floors, one bottom skin above each open lower surface;
/// - sides, on the outlines.
///
/// The radius of the points on roofs is so large that together they cover all of the roof. Points
/// on floors and sides are at most `step_nm` apart in both directions, and their radius is 0.
void ForEachSurfacePlace(const ObjectStack& stack, const SkinLayers& skins, Coord step_nm,
                         const TakePlace& take);

/// Visits only points on roofs, and only below surfaces that lean less than 45 degrees.
void ForEachRoofPlace(const ObjectStack& stack, const SkinLayers& skins, Coord step_nm,
                      const TakePlace& take);

/// Visits points all over the inside of a stack's region, about `step_nm` apart in all directions.
void ForEachInnerPlace(const ObjectStack& stack, Coord step_nm,
                       const std::function<void(Point place, Coord z_nm)>& take);

}  // namespace slicefarm::planning
