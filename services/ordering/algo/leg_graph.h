#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/tour_rules.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// A journey along legs as a closed tour: the ends of a leg are two nodes (of a leg without length,
/// one) with a fixed edge between them; the journey's end, or nowhere, has a fixed edge to its
/// start. What may not be reversed has its start before its end.
class LegGraph {
 public:
  LegGraph(const Journey& journey, std::span<const Leg> legs);

  const Costs& costs() const { return costs_; }
  const TourRules& rules() const { return rules_; }
  Point At(int32_t node) const;

  Tour TourOf(std::span<const Visit> visits) const;
  std::vector<Visit> VisitsOf(const Tour& tour) const;

 private:
  struct Ends {
    int32_t start;
    int32_t end;
  };

  void AddRules(const Journey& journey, std::span<const Leg> legs);

  std::vector<Ends> ends_;      ///< by leg
  std::vector<Visit> entered_;  ///< by node: the leg, and whether it is the end
  Costs costs_;
  TourRules rules_;
};

}  // namespace slicefarm::ordering
