#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace slicefarm {

/// Partition of the numbers from 0 to n - 1 into disjoint sets, which are joined step by step.
/// Source: Galler and Fischer 1964; Tarjan, with path halving. Cost: O(log n) per call, amortised.
class DisjointSets {
 public:
  /// Makes a set of its own for each number from 0 to count - 1.
  explicit DisjointSets(int32_t count) : root_(static_cast<size_t>(count)), sets_(count) {
    std::iota(root_.begin(), root_.end(), 0);
  }

  int32_t sets() const { return sets_; }

  /// Joins the set of `a` and the set of `b`. Returns false if they were already the same set.
  bool Join(int32_t a, int32_t b) {
    const int32_t root_a = RootOf(a), root_b = RootOf(b);
    if (root_a == root_b) return false;
    root_[static_cast<size_t>(std::max(root_a, root_b))] = std::min(root_a, root_b);
    --sets_;
    return true;
  }

  bool AreJoined(int32_t a, int32_t b) { return RootOf(a) == RootOf(b); }

  /// Returns the smallest number of the set of `number`.
  int32_t RootOf(int32_t number) {
    while (root_[static_cast<size_t>(number)] != number) {
      int32_t& up = root_[static_cast<size_t>(number)];
      up = root_[static_cast<size_t>(up)];
      number = up;
    }
    return number;
  }

 private:
  std::vector<int32_t> root_;
  int32_t sets_;
};

}  // namespace slicefarm
