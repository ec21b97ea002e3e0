#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace slicefarm::ordering {

/// Disjoint sets of nodes that are joined one by one. Source: Tarjan, with halved paths.
class NodeSets {
 public:
  /// Each node by itself.
  explicit NodeSets(int32_t nodes) : root_(static_cast<size_t>(nodes)) {
    std::iota(root_.begin(), root_.end(), 0);
  }

  /// Makes one set of the two. False: they were one already.
  bool Join(int32_t a, int32_t b) {
    const int32_t root_a = RootOf(a);
    const int32_t root_b = RootOf(b);
    root_[static_cast<size_t>(root_a)] = root_b;
    return root_a != root_b;
  }

 private:
  int32_t RootOf(int32_t node) {
    while (root_[static_cast<size_t>(node)] != node) {
      int32_t& up = root_[static_cast<size_t>(node)];
      up = root_[static_cast<size_t>(up)];
      node = up;
    }
    return node;
  }

  std::vector<int32_t> root_;
};

}  // namespace slicefarm::ordering
