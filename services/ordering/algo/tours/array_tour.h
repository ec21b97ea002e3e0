#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::ordering {

/// Range of tour positions that is reversed in memory, from `from` to `to` inclusive. It continues
/// at position 0 if `to` is less than `from`.
struct Reversal {
  int32_t from;
  int32_t to;
};

/// Closed tour stored in an array of n nodes. A query for a neighbour or a position costs O(1), the
/// reversal of a section O(n). The array may contain the tour in either direction.
class ArrayTour {
 public:
  /// Stores the nodes of `tour` in their order.
  explicit ArrayTour(Tour tour);

  int32_t size() const { return static_cast<int32_t>(order_.size()); }
  const Tour& order() const { return order_; }
  /// Returns the node at a position.
  int32_t At(int32_t position) const { return order_[static_cast<size_t>(position)]; }
  /// Returns the position of a node.
  int32_t PositionOf(int32_t node) const { return position_[static_cast<size_t>(node)]; }
  /// Returns the node after `node`.
  int32_t Next(int32_t node) const {
    const int32_t position = PositionOf(node) + 1;
    return At(position < size() ? position : 0);
  }
  /// Returns the node before `node`.
  int32_t Previous(int32_t node) const {
    const int32_t position = PositionOf(node);
    return At(position > 0 ? position - 1 : size() - 1);
  }

  /// Reverses the section from node a forward to node b, or all other nodes if they are fewer. Both
  /// give the same closed tour. Returns the reversed positions.
  Reversal Reverse(int32_t a, int32_t b);
  /// Reverses the section at the positions of `turn`. A second call restores the tour.
  void Reverse(Reversal turn);

  /// Returns the number of positions that `turn` reverses in a tour of `size` nodes.
  static int32_t Length(Reversal turn, int32_t size) {
    const int32_t steps = turn.to - turn.from;
    return (steps < 0 ? steps + size : steps) + 1;
  }

 private:
  Tour order_;
  std::vector<int32_t> position_;  ///< position of each node, indexed by node
};

}  // namespace slicefarm::ordering
