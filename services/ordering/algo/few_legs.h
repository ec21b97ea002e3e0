#pragma once

#include <functional>
#include <span>
#include <vector>

#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// Up to so many legs, to try all orders takes no longer than to improve one.
inline constexpr size_t kFewLegs = 6;

/// The cost of a travel.
using TravelCost = std::function<int64_t(Point from, Point to)>;

/// The order and directions of least cost. The first of equals by the numbers of the legs from the
/// end. Cost: O(2^n n^2). REQUIRES: at most kFewLegs. Source: M. Held, R. M. Karp, "A Dynamic
/// Programming Approach to Sequencing Problems", J. SIAM 10 (1962).
std::vector<Visit> BestOrder(const Journey& journey, std::span<const Leg> legs,
                             const TravelCost& cost);

}  // namespace slicefarm::ordering
