#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <vector>

#include "common/geometry/skeleton/boundary.h"
#include "common/geometry/vector.h"

namespace slicefarm {

/// An edge of a boundary in doubles, in nm from the boundary's origin.
struct Site {
  Vector2 from;
  Vector2 direction;  ///< unit vector along the edge
  double length = 0;
  bool starts_reflex = false;  ///< true if the region has a reflex corner at `from`

  Vector2 To() const { return from + length * direction; }
  /// Returns the signed distance of `p` from the line of the edge, positive on the region's side.
  double SideOf(const Vector2& p) const { return Cross(direction, p - from); }
  /// Returns the position of the foot of `p` on the line of the edge, from the edge's start.
  double Along(const Vector2& p) const { return Dot(direction, p - from); }
};

/// The edges of a boundary as sites, in a tree of boxes with four children per node. Neighbouring
/// edges of a ring are neighbours in the tree. The rings are in the order of a space-filling curve.
class SiteTree {
 public:
  explicit SiteTree(const Boundary& boundary);

  const Site& operator[](int edge) const { return sites_[edge]; }
  /// Returns the length of the diagonal of the box around all sites, in nm.
  double Diagonal() const { return diagonal_; }

  /// Calls visit(edge) for all edges of which the squared distance from `p` is at most `limit`, and
  /// for some edges near them. `visit` can reduce `limit`. Cost: O(log n) for n edges, plus the
  /// edges found.
  template <typename Visit>
  void ForEachWithin(const Vector2& p, const double& limit, const Visit& visit) const {
    const Eigen::Array4f x = Eigen::Array4f::Constant(static_cast<float>(p.x()));
    const Eigen::Array4f y = Eigen::Array4f::Constant(static_cast<float>(p.y()));
    std::array<int, kMostOpen> open;
    int size = 0;
    open[size++] = 0;
    while (size > 0) {
      const int node = open[--size];
      if (node >= first_leaf_) {
        const int begin = kChildren * (node - first_leaf_);
        const int end = std::min(begin + kChildren, static_cast<int>(order_.size()));
        for (int i = begin; i < end; ++i) visit(order_[i]);
        continue;
      }
      const Children& boxes = children_[node];
      const Eigen::Array4f beside = (boxes.left - x).max(x - boxes.right).max(0.f);
      const Eigen::Array4f above = (boxes.bottom - y).max(y - boxes.top).max(0.f);
      const Eigen::Array4f squared = beside * beside + above * above;
      for (int i = 0; i < kChildren; ++i)
        if (squared[i] <= limit) open[size++] = kChildren * node + 1 + i;
    }
  }

 private:
  static constexpr int kChildren = 4;
  /// Upper limit on the nodes that wait at once: three per level of the tree, for 2^31 edges.
  static constexpr int kMostOpen = 64;

  /// Boxes of the four children of a node, in single precision and therefore a bit larger.
  struct Children {
    Eigen::Array4f left, right, bottom, top;
  };

  void MakeOrder(const Boundary& boundary);
  void MakeBoxes();

  std::vector<Site> sites_;  ///< sites of the edges of the boundary
  std::vector<int> order_;   ///< edges in the order of the leaves
  double diagonal_ = 0;
  /// Node of the first leaf. Node i has the children 4 i + 1 to 4 i + 4. A leaf has four edges.
  int first_leaf_ = 0;
  std::vector<Children> children_;  ///< boxes of the children of each inner node
};

}  // namespace slicefarm
