#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "common/geometry/point.h"
#include "services/ordering/algo/comb/barrier.h"
#include "services/ordering/algo/tours/work_budget.h"

namespace slicefarm::ordering {

/// A stretch that is printed in one go, from `start` to `end` or, if reversible, the other way
/// round. What lies between does not matter for the travel. A loop is a leg that ends where it
/// starts.
struct Leg {
  Point start;
  Point end;
  bool reversible = true;
};

/// `leg` comes before `next`.
struct Precedence {
  uint32_t leg = 0;
  uint32_t next = 0;
};

/// Where the nozzle comes from, and where it goes when all legs are done (nowhere in particular if
/// absent).
struct Journey {
  Point from;
  std::optional<Point> to;
  const Barrier* barrier = nullptr;             ///< what had better not be crossed on the way
  std::span<const Precedence> precedence = {};  ///< without circles
};

/// What a crossing costs, in travel: a retraction takes about as long as 7 mm, and leaves a mark.
inline constexpr int64_t kCrossingNm = 10 * kNmPerMm;

struct Visit {
  uint32_t leg = 0;
  bool reversed = false;

  friend bool operator==(const Visit&, const Visit&) = default;
};

/// An order and direction of all `legs` with little travel: the best of up to kFewLegs (few_legs.h),
/// of more the nearest neighbour's and then TourSearch's, with a number of exchanges in proportion to
/// the legs, or until `budget` is spent; without budget the nearest neighbour's. Then, around each
/// travel that crosses the barrier, the same moves with crossings counted as travel of kCrossingNm.
///
/// The journey is a path with a fixed start and, if asked for, a fixed end. Shapes: each leg once.
/// A leg that is not reversible is never reversed; the precedence is kept. Deterministic. Cost:
/// O(n log n) and the moves tried, each O(1) to judge and O(n) to make.
std::vector<Visit> OrderByTravel(const Journey& journey, std::span<const Leg> legs,
                                 WorkBudget& budget);

/// Length in nm of the travel in between, from `journey.from` to the first leg and from the last to
/// `journey.to`.
double TravelLength(const Journey& journey, std::span<const Leg> legs,
                    std::span<const Visit> visits);

}  // namespace slicefarm::ordering
