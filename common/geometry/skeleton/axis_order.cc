#include "common/geometry/skeleton/axis_order.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace slicefarm {
namespace {

/// Position of the sweeping line, and the half-edge that an edge begins with.
using Passed = std::pair<double, int>;

std::vector<Passed> PassedEdges(const SkeletalGraph& axis) {
  const auto passed = [&](int half) {
    const SkeletalNode& node = axis.FromNode(half);
    return node.place.x() + node.radius;
  };
  std::vector<Passed> order;
  for (int half = 0; half < static_cast<int>(axis.half_edges.size()); half += 2) {
    if (axis.half_edges[half].from < 0) continue;
    const double from = passed(half), to = passed(half + 1);
    order.emplace_back(std::min(from, to), from < to ? half + 1 : half);
  }
  std::sort(order.begin(), order.end());
  return order;
}

}  // namespace

SkeletalGraph InSweepOrder(SkeletalGraph axis) {
  const std::vector<Passed> order = PassedEdges(axis);
  std::vector<int> now(axis.half_edges.size(), -1);
  for (size_t i = 0; i < order.size(); ++i) {
    now[order[i].second] = static_cast<int>(2 * i);
    now[order[i].second ^ 1] = static_cast<int>(2 * i + 1);
  }
  std::vector<HalfEdge> sorted(2 * order.size());
  for (size_t half = 0; half < now.size(); ++half) {
    if (now[half] < 0) continue;
    HalfEdge edge = axis.half_edges[half];
    edge.next = now[edge.next];
    edge.previous = now[edge.previous];
    sorted[now[half]] = edge;
  }
  axis.half_edges = std::move(sorted);
  return axis;
}

}  // namespace slicefarm
