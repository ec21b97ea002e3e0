#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "common/geometry/vector.h"
#include "services/ordering/algo/tours/costs.h"

namespace slicefarm::ordering {

/// A k-d tree over numbered places from which places can be taken out. Answers depend on the places
/// and their numbers only, also where distances are equal. Cost: O(n log^2 n) to build; O(log n) to
/// take out; O(log n) as a rule to ask, also for places that coincide.
class PlaceTree {
 public:
  static constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

  explicit PlaceTree(std::span<const Vector2> places);

  /// REQUIRES: `number` is in the tree.
  void Remove(uint32_t number);
  /// REQUIRES: `number` was taken out.
  void Restore(uint32_t number);

  /// The nearest place that is still in the tree; kNone if there is none.
  uint32_t Nearest(Vector2 to) const;

  /// Places on one side of a place in x and in y.
  struct Quadrant {
    bool right;
    bool above;
  };

  /// Up to `count` places still in the tree other than `except`, nearest first; with a quadrant
  /// only those in it.
  void NearestFew(Vector2 to, uint32_t except, size_t count, std::vector<uint32_t>& found,
                  std::optional<Quadrant> quadrant = {}) const;

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
    uint32_t except;
    size_t count;
    std::optional<Quadrant> quadrant;
    std::vector<Candidate> best;  ///< sorted

    bool Admits(const Node& node) const {
      if (node.removed || node.number == except) return false;
      return !quadrant || ((node.x >= x) == quadrant->right && (node.y >= y) == quadrant->above);
    }
    /// Whether what is not wanted lies on the lower (else the upper) side of the node.
    bool Skips(const Node& node, bool lower) const {
      if (!quadrant) return false;
      const double split = node.split_x ? node.x : node.y;
      const double at = node.split_x ? x : y;
      const bool upper_wanted = node.split_x ? quadrant->right : quadrant->above;
      return lower ? upper_wanted && split < at : !upper_wanted && split >= at;
    }
  };

  void Build(size_t first, size_t last);
  void Count(size_t position, uint32_t more);
  void SearchNearest(size_t first, size_t last, double x, double y, Candidate& best) const;
  void SearchFew(size_t first, size_t last, FewQuery& query) const;

  std::vector<Node> nodes_;         ///< the root of [first, last) is its middle
  std::vector<uint32_t> position_;  ///< in nodes_, by number
};

}  // namespace slicefarm::ordering
