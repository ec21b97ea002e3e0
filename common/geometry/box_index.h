#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"

namespace slicefarm {

/// Index of boxes, to find all that meet another box. It is a tree of boxes around boxes.
class BoxIndex {
 public:
  /// Cost: O(n log n), n boxes.
  explicit BoxIndex(std::vector<Box> boxes);
  /// Builds the index of the islands' boxes.
  explicit BoxIndex(const MultiPolygon& islands);

  /// Returns the indices of the boxes that meet `box`, ascending. Cost: O(log n + k log k), k found
  /// boxes, if few boxes overlap.
  std::vector<size_t> Meeting(const Box& box) const;

 private:
  /// Boxes from `first` to before `end` in `order_`.
  struct Node {
    Box around;
    size_t first = 0, end = 0;
    size_t after = 0;  ///< index of the node after this one's descendants
  };
  void Build(size_t first, size_t end);

  std::vector<Box> boxes_;
  std::vector<size_t> order_;
  std::vector<Node> nodes_;  ///< each node directly before its descendants
};

/// Returns the islands with boxes that meet a box, in their order. `index`: index of `islands`.
MultiPolygon IslandsNear(const Box& box, const MultiPolygon& islands, const BoxIndex& index);

}  // namespace slicefarm
