#pragma once

#include <functional>
#include <span>
#include <vector>

#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// Largest number of legs for which BestOrder takes no longer than the improvement of one order by
/// TourSearch.
inline constexpr size_t kFewLegs = 6;

/// Cost of a travel.
using TravelCost = std::function<int64_t(Point from, Point to)>;

/// Returns the order and directions with the lowest cost. If several orders have this cost, returns
/// the one with the lowest leg indices, compared from the last leg to the first. Cost: O(2^n n^2),
/// n legs. REQUIRES: at most kFewLegs legs. Source: M. Held, R. M. Karp, "A Dynamic Programming
/// Approach to Sequencing Problems", J. SIAM 10 (1962).
std::vector<Visit> BestOrder(const Journey& journey, std::span<const TourLeg> legs,
                             const TravelCost& cost);

}  // namespace slicefarm::ordering
