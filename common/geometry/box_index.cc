#include "common/geometry/box_index.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace slicefarm {
namespace {

/// Largest number of boxes of a node without descendants.
constexpr size_t kLeafBoxes = 8;

std::vector<Box> BoxesOf(const MultiPolygon& islands) {
  std::vector<Box> boxes;
  boxes.reserve(islands.size());
  for (const PolygonWithHoles& island : islands) boxes.push_back(Bounds(island.outer));
  return boxes;
}

}  // namespace

BoxIndex::BoxIndex(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
  std::iota(order_.begin(), order_.end(), size_t{0});
  // Empty boxes have no middle.
  std::erase_if(order_, [this](size_t i) { return boxes_[i].Empty(); });
  if (!order_.empty()) Build(0, order_.size());
}

BoxIndex::BoxIndex(const MultiPolygon& islands) : BoxIndex(BoxesOf(islands)) {}

/// Adds the node of a range of `order_` and its descendants. The longer side of the box is halved.
void BoxIndex::Build(size_t first, size_t end) {
  const size_t at = nodes_.size();
  Node node{.around = {}, .first = first, .end = end};
  for (size_t i = first; i < end; ++i) node.around.Add(boxes_[order_[i]]);
  nodes_.push_back(node);
  if (end - first > kLeafBoxes) {
    const Box& box = node.around;
    const bool along_x = box.max.x - box.min.x > box.max.y - box.min.y;
    const auto twice_middle = [&](size_t i) {
      return along_x ? boxes_[i].min.x + boxes_[i].max.x : boxes_[i].min.y + boxes_[i].max.y;
    };
    const size_t middle = first + (end - first) / 2;
    const auto begin = order_.begin();
    std::ranges::nth_element(begin + static_cast<std::ptrdiff_t>(first),
                             begin + static_cast<std::ptrdiff_t>(middle),
                             begin + static_cast<std::ptrdiff_t>(end), {}, twice_middle);
    Build(first, middle);
    Build(middle, end);
  }
  nodes_[at].after = nodes_.size();
}

std::vector<size_t> BoxIndex::Meeting(const Box& box) const {
  std::vector<size_t> found;
  for (size_t at = 0; at < nodes_.size();) {
    const Node& node = nodes_[at];
    if (!node.around.Intersects(box)) {
      at = node.after;
      continue;
    }
    ++at;
    if (node.end - node.first > kLeafBoxes) continue;
    for (size_t i = node.first; i < node.end; ++i)
      if (boxes_[order_[i]].Intersects(box)) found.push_back(order_[i]);
  }
  std::ranges::sort(found);
  return found;
}

MultiPolygon IslandsNear(const Box& box, const MultiPolygon& islands, const BoxIndex& index) {
  MultiPolygon near;
  for (const size_t i : index.Meeting(box)) near.push_back(islands[i]);
  return near;
}

}  // namespace slicefarm
