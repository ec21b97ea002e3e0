#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "common/geometry/vector.h"
#include "services/ordering/algo/tours/costs.h"

namespace slicefarm::ordering {

/// k-d tree over numbered points; points can be removed and restored. Results depend only on the
/// points and their numbers, even if distances are equal. Cost: O(n log^2 n) to build, n points;
/// O(log n) to remove; usually O(log n) per query, even if many points coincide.
class PointTree {
 public:
  static constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

  /// Builds the tree. A point's number is its index in `points`.
  explicit PointTree(std::span<const Vector2> points);

  /// Removes a point. REQUIRES: `number` is in the tree.
  void Remove(uint32_t number);
  /// Adds a removed point again. REQUIRES: `number` was removed.
  void Restore(uint32_t number);

  /// Returns the number of the nearest point in the tree, or kNone if the tree is empty.
  uint32_t Nearest(Vector2 to) const;

  /// Quadrant of the plane around a point.
  struct Quadrant {
    bool right;
    bool above;
  };

  /// Writes the numbers of up to `count` points in the tree, nearest first, without `except`, to
  /// `found`. If a quadrant around `to` is given, only points in this quadrant are written.
  void NearestFew(Vector2 to, uint32_t except, size_t count, std::vector<uint32_t>& found,
                  std::optional<Quadrant> quadrant = {}) const;

 private:
  struct Node {
    double x;
    double y;
    uint32_t number;
    uint32_t alive;  ///< number of points in the subtree that are not removed
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
    std::vector<Candidate> best;  ///< best candidates, sorted by distance

    bool Admits(const Node& node) const {
      if (node.removed || node.number == except) return false;
      return !quadrant || ((node.x >= x) == quadrant->right && (node.y >= y) == quadrant->above);
    }
    /// Returns true if one side of the node contains no point in the quadrant: the lower side if
    /// `lower`, else the upper side.
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

  std::vector<Node> nodes_;         ///< the root of each subtree [first, last) is its middle entry
  std::vector<uint32_t> position_;  ///< index in nodes_, indexed by the point's number
};

}  // namespace slicefarm::ordering
