#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/ordering/algo/tours/costs.h"

namespace slicefarm::ordering {

/// A near node and its distance.
struct Neighbour {
  int32_t node;
  int64_t length;
};

/// Near nodes of each node, nearest first. The `nowhere` node is a neighbour of every node and has
/// no neighbours itself.
class Neighbours {
 public:
  /// Finds up to `count` neighbours of each node, not counting nowhere. For places it also finds up
  /// to `per_quadrant` neighbours in each of the four quadrants, because the nearest places of a
  /// cluster are all in the same cluster. Cost: O(n log n) for places, O(n^2) for a table.
  Neighbours(const Costs& costs, size_t count, size_t per_quadrant);

  /// Returns the neighbours of a node, nearest first.
  std::span<const Neighbour> Of(int32_t node) const {
    const uint32_t begin = begin_[static_cast<size_t>(node)];
    return std::span(all_).subspan(begin, begin_[static_cast<size_t>(node) + 1] - begin);
  }

 private:
  std::vector<Neighbour> all_;
  /// first index of each node in `all_`, and the end of the last node
  std::vector<uint32_t> begin_;
};

}  // namespace slicefarm::ordering
