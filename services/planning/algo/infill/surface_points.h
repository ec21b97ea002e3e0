#pragma once

#include <functional>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// What is told of a point: its place, and its height above the object's bottom.
using TakePoint = std::function<void(Point place, Coord z_nm)>;

/// Points all over the surface of an object's layers, in both directions not farther apart than
/// `step_nm`: on the outlines, and on what is open above or below.
void ForEachSurfacePoint(const ObjectStack& stack, Coord step_nm, const TakePoint& take);

/// The same of tops alone: what is open above and leans less than 45 degrees.
void ForEachTopPoint(const ObjectStack& stack, Coord step_nm, const TakePoint& take);

}  // namespace slicefarm::planning
