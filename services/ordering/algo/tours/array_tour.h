#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::ordering {

/// Positions of a tour, from..to, whose order was turned round in memory.
struct Turn {
  int32_t from;
  int32_t to;
};

/// A closed tour in an array: O(1) to ask for a neighbour or what lies between, O(n) to turn a
/// stretch round. Which way round the tour lies in memory has no meaning.
class ArrayTour {
 public:
  explicit ArrayTour(Tour tour);

  int32_t size() const { return static_cast<int32_t>(order_.size()); }
  const Tour& order() const { return order_; }
  int32_t At(int32_t position) const { return order_[static_cast<size_t>(position)]; }
  int32_t PositionOf(int32_t node) const { return position_[static_cast<size_t>(node)]; }
  int32_t Next(int32_t node) const {
    const int32_t position = PositionOf(node) + 1;
    return At(position < size() ? position : 0);
  }
  int32_t Previous(int32_t node) const {
    const int32_t position = PositionOf(node);
    return At(position > 0 ? position - 1 : size() - 1);
  }

  /// Turns the stretch from a forward to b round, or all the rest, which gives the same tour the
  /// other way round: whichever is shorter.
  Turn TurnRound(int32_t a, int32_t b);
  /// Turns the positions round; done twice, nothing has changed.
  void TurnRound(Turn turn);

  /// Whether TurnRound(a, b) turned all but that stretch.
  static int32_t Length(Turn turn, int32_t size) {
    const int32_t steps = turn.to - turn.from;
    return (steps < 0 ? steps + size : steps) + 1;
  }

 private:
  Tour order_;
  std::vector<int32_t> position_;  ///< by node
};

}  // namespace slicefarm::ordering
