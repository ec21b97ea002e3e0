#pragma once

#include <vector>

#include "services/planning/algo/infill/object_stack.h"

namespace slicefarm::planning {

/// Returns, for each layer, the middle of the connected body of each island of StackLayer::whole,
/// in the order of the islands. Islands of neighbouring layers belong to one body if they overlap.
/// The middle is the middle of the body's bounding box in x and y. Cost: O(n log n) for n points of
/// each layer that is not equal to the one below, and O(islands) for other layers.
std::vector<std::vector<Point>> BodyMiddles(const ObjectStack& stack);

}  // namespace slicefarm::planning
