#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/geometry/point.h"
#include "services/ordering/algo/comb/barrier.h"
#include "services/ordering/algo/tours/work_budget.h"

namespace slicefarm::ordering {

/// Path that is printed without interruption, from `start` to `end` or, if reversible, from `end`
/// to `start`. Its course between the ends does not affect the travel. A loop is a leg that ends at
/// its start.
struct TourLeg {
  Point start;
  Point end;
  bool reversible = true;
};

/// Rule that `leg` is printed before `next`.
struct Precedence {
  uint32_t leg = 0;
  uint32_t next = 0;
};

/// Positions of the nozzle before and after all legs. Without `to`, the journey may end anywhere.
struct Journey {
  Point from;
  std::optional<Point> to;
  const Barrier* barrier = nullptr;             ///< obstacle that travels should not cross
  std::span<const Precedence> precedence = {};  ///< rules without cycles
};

/// Cost of a travel's crossing of the barrier, in nm of travel. A retraction takes about as long as
/// 7 mm of travel, and leaves a mark.
inline constexpr int64_t kCrossingNm = 10 * kNmPerMm;

/// A leg in an order, and true if it is printed in reverse direction.
struct Visit {
  uint32_t leg = 0;
  bool reversed = false;

  friend bool operator==(const Visit&, const Visit&) = default;
};

/// Returns an order and direction of all `legs` with little travel. For up to kFewLegs legs, the
/// order is the best one (few_legs.h). For more legs, TourSearch improves the nearest-neighbour
/// order. Its number of exchanges is in proportion to the number of legs; it ends when `budget` is
/// spent. Without budget, the result is the nearest-neighbour order. Finally the search continues
/// around each travel that crosses the barrier, where each crossing counts as kCrossingNm of
/// travel.
///
/// The journey is a path with a fixed start and, if requested, a fixed end. Shapes: each leg once.
/// A leg that is not reversible is never reversed, and the precedence is kept. Deterministic. Cost:
/// O(n log n), n legs, and the tried moves, each O(1) to judge and O(n) to make.
std::vector<Visit> OrderByTravel(const Journey& journey, std::span<const TourLeg> legs,
                                 WorkBudget& budget);

/// Returns the length in nm of the travel between legs, from `journey.from` to the first leg and
/// from the last leg to `journey.to`.
double TravelLength(const Journey& journey, std::span<const TourLeg> legs,
                    std::span<const Visit> visits);

}  // namespace slicefarm::ordering
