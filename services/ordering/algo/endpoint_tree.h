#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm::ordering {

/// A k-d tree over numbered points from which points can be taken out. Answers depend on the points
/// and their numbers only, also where distances are equal. Cost: O(n log^2 n) to build; O(log n) to
/// take out; O(log n) as a rule to ask, also for points that coincide.
class EndpointTree {
 public:
  static constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

  explicit EndpointTree(std::span<const Point> points);

  /// REQUIRES: `number` is in the tree.
  void Remove(uint32_t number);

  /// The nearest point that is still in the tree; kNone if there is none.
  uint32_t Nearest(Point to) const;

  /// Up to `count` points still in the tree whose number / 2 is not `except / 2`, nearest first:
  /// the two ends of a leg have numbers that differ in the last bit, and are no neighbours.
  void NearestFew(Point to, uint32_t except, size_t count, std::vector<uint32_t>& found) const;

 private:
  struct Node {
    double x;
    double y;
    uint32_t number;
    uint32_t alive;  ///< in the subtree
    bool removed;
    bool split_x;
  };
  struct Candidate {
    double distance2;
    uint32_t number;

    bool Before(const Candidate& other) const {
      return distance2 < other.distance2 || (distance2 == other.distance2 && number < other.number);
    }
  };
  struct FewQuery {
    double x;
    double y;
    uint32_t except_leg;
    size_t count;
    std::vector<Candidate> best;  ///< sorted
  };

  void Build(size_t first, size_t last);
  void SearchNearest(size_t first, size_t last, double x, double y, Candidate& best) const;
  void SearchFew(size_t first, size_t last, FewQuery& query) const;

  std::vector<Node> nodes_;         ///< the root of [first, last) is its middle
  std::vector<uint32_t> position_;  ///< in nodes_, by number
};

}  // namespace slicefarm::ordering
