#pragma once

#include <functional>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// What is told of a place: its height above the object's bottom, and how far it reaches in the
/// plane.
using TakePlace = std::function<void(Point place, Coord z_nm, double around_nm)>;

/// Which of a stack's layers are solid next to what is open.
struct SkinLayers {
  int32_t top = 0;
  int32_t bottom = 0;
};

/// Places where an object's sparse infill ends, in the middle of the layers' heights: roofs, as far
/// below all that is open above as skins reach; floors, as far above all that is open below; and
/// sides, on the outlines. Those of roofs reach far enough that no place of a roof is left out; all
/// others are told at most `step_nm` apart, in both directions, and reach no further than they lie.
void ForEachSurfacePlace(const ObjectStack& stack, const SkinLayers& skins, Coord step_nm,
                         const TakePlace& take);

/// Those of roofs alone, and of these what lies under what leans less than 45 degrees.
void ForEachRoofPlace(const ObjectStack& stack, const SkinLayers& skins, Coord step_nm,
                      const TakePlace& take);

/// Places all over the inside of a stack's region, about `step_nm` apart in all directions.
void ForEachInnerPlace(const ObjectStack& stack, Coord step_nm,
                       const std::function<void(Point place, Coord z_nm)>& take);

}  // namespace slicefarm::planning
