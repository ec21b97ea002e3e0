#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "services/ordering/algo/tours/costs.h"

namespace slicefarm::ordering {

struct Neighbour {
  int32_t node;
  int64_t length;
};

/// For each node some near ones, nearest first. `nowhere` is everybody's neighbour and has none
/// itself.
class Neighbours {
 public:
  /// Up to `count` of each node, besides nowhere, and between places up to `per_quadrant` in each
  /// of the four directions: where places come in clusters, the nearest are all in one. Cost:
  /// O(n log n) between places, O(n^2) of a table.
  Neighbours(const Costs& costs, size_t count, size_t per_quadrant);

  std::span<const Neighbour> Of(int32_t node) const {
    const uint32_t begin = begin_[static_cast<size_t>(node)];
    return std::span(all_).subspan(begin, begin_[static_cast<size_t>(node) + 1] - begin);
  }

 private:
  std::vector<Neighbour> all_;
  std::vector<uint32_t> begin_;  ///< by node, and one more
};

}  // namespace slicefarm::ordering
