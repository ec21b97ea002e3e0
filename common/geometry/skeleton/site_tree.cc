#include "common/geometry/skeleton/site_tree.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>

namespace slicefarm {
namespace {

/// Returns the index of a point on the Z-order curve.
uint64_t ZOrder(uint32_t x, uint32_t y) {
  const auto spread = [](uint64_t bits) {
    bits = (bits | bits << 16) & 0x0000ffff0000ffff;
    bits = (bits | bits << 8) & 0x00ff00ff00ff00ff;
    bits = (bits | bits << 4) & 0x0f0f0f0f0f0f0f0f;
    bits = (bits | bits << 2) & 0x3333333333333333;
    return (bits | bits << 1) & 0x5555555555555555;
  };
  return spread(x) | spread(y) << 1;
}

}  // namespace

SiteTree::SiteTree(const Boundary& boundary) {
  const auto unit = static_cast<double>(boundary.unit_nm);
  sites_.reserve(boundary.edges.size());
  for (const BoundaryEdge& edge : boundary.edges) {
    const Vector2 along = unit * ToVector(edge.to - edge.from);
    const double length = Norm(along);
    sites_.push_back({unit * ToVector(edge.from), along / length, length,
                      boundary.StartsReflex(static_cast<int>(sites_.size()))});
  }
  MakeOrder(boundary);
  MakeBoxes();
}

void SiteTree::MakeOrder(const Boundary& boundary) {
  struct Ring {
    uint64_t place = 0;
    int first = 0;
    int edges = 0;
  };
  std::vector<Ring> rings;
  int first = 0;
  for (const Polygon& ring : boundary.rings) {
    const Point start = boundary.edges[first].from;
    constexpr Coord kMiddle = Coord{1} << 31;
    rings.push_back(
        {ZOrder(static_cast<uint32_t>(start.x + kMiddle), static_cast<uint32_t>(start.y + kMiddle)),
         first, static_cast<int>(ring.size())});
    first += rings.back().edges;
  }
  std::stable_sort(rings.begin(), rings.end(),
                   [](const Ring& a, const Ring& b) { return a.place < b.place; });
  order_.reserve(sites_.size());
  for (const Ring& ring : rings)
    for (int i = 0; i < ring.edges; ++i) order_.push_back(ring.first + i);
}

void SiteTree::MakeBoxes() {
  const size_t leaves = (order_.size() + kChildren - 1) / kChildren;
  size_t level = 1;
  while (level < leaves) {
    first_leaf_ += static_cast<int>(level);
    level *= kChildren;
  }
  constexpr float kFar = std::numeric_limits<float>::max();
  std::vector<Eigen::AlignedBox2d> boxes(first_leaf_ + level);
  for (size_t i = 0; i < order_.size(); ++i) {
    Eigen::AlignedBox2d& box = boxes[first_leaf_ + i / kChildren];
    box.extend(sites_[order_[i]].from).extend(sites_[order_[i]].To());
  }
  for (size_t node = boxes.size() - 1; node > 0; --node)
    boxes[(node - 1) / kChildren].extend(boxes[node]);
  diagonal_ = boxes[0].diagonal().norm();
  // Covers the rounding of the boxes and of the points of queries to single precision.
  const double margin =
      1e-6 * std::max(boxes[0].min().cwiseAbs().maxCoeff(), boxes[0].max().cwiseAbs().maxCoeff());
  children_.resize(first_leaf_);
  for (int node = 0; node < first_leaf_; ++node) {
    for (int i = 0; i < kChildren; ++i) {
      const Eigen::AlignedBox2d& box = boxes[kChildren * node + 1 + i];
      Children& children = children_[node];
      const bool empty = box.isEmpty();
      children.left[i] = empty ? kFar : static_cast<float>(box.min().x() - margin);
      children.right[i] = empty ? kFar : static_cast<float>(box.max().x() + margin);
      children.bottom[i] = empty ? kFar : static_cast<float>(box.min().y() - margin);
      children.top[i] = empty ? kFar : static_cast<float>(box.max().y() + margin);
    }
  }
}

}  // namespace slicefarm
