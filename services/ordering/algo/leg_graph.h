#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/tour_rules.h"
#include "services/ordering/algo/travel_order.h"

namespace slicefarm::ordering {

/// Graph that turns a journey along legs (travel_order.h) into a closed tour. The two ends of a leg
/// are two nodes with a fixed edge between them. A leg without length is one node. A fixed edge
/// joins the journey's end to its start. If the journey has no fixed end, an extra node with
/// distance 0 to all others takes its place. For a leg that may not be reversed, a rule puts its
/// start before its end.
class LegGraph {
 public:
  /// Builds the nodes, costs and rules.
  LegGraph(const Journey& journey, std::span<const TourLeg> legs);

  const Costs& costs() const { return costs_; }
  const TourRules& rules() const { return rules_; }
  /// Returns the position of a node.
  Point At(int32_t node) const;

  /// Returns the tour over the legs in this order and direction.
  Tour TourOf(std::span<const Visit> visits) const;
  /// Returns the order and direction of the legs in a tour.
  std::vector<Visit> VisitsOf(const Tour& tour) const;

 private:
  struct Ends {
    int32_t start;
    int32_t end;
  };

  void AddRules(const Journey& journey, std::span<const TourLeg> legs);

  std::vector<Ends> ends_;  ///< end nodes of each leg, indexed by leg
  /// Leg to which each node belongs, and true if the node is the leg's end; indexed by node.
  std::vector<Visit> entered_;
  Costs costs_;
  TourRules rules_;
};

}  // namespace slicefarm::ordering
