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

/// Near nodes of each node, nearest first. The node of Costs::AddNowhere is a neighbour of every
/// node and has no neighbours itself.
class Neighbours {
 public:
  /// Finds up to `count` neighbours of each node, without the node of AddNowhere. If nodes are
  /// points, also finds up to `per_quadrant` neighbours in each quadrant around the node. The
  /// reason: the nearest points of a cluster may all be in the same cluster. Cost: O(n log n) for n
  /// points, O(n^2) for a table.
  Neighbours(const Costs& costs, size_t count, size_t per_quadrant);

  /// Returns the neighbours of a node, nearest first.
  std::span<const Neighbour> Of(int32_t node) const {
    const uint32_t begin = begin_[static_cast<size_t>(node)];
    return std::span(all_).subspan(begin, begin_[static_cast<size_t>(node) + 1] - begin);
  }

 private:
  std::vector<Neighbour> all_;
  /// Index in `all_` of each node's first neighbour; one more entry than nodes.
  std::vector<uint32_t> begin_;
};

}  // namespace slicefarm::ordering
