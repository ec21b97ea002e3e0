#include "services/ordering/algo/tours/point_tree.h"

#include <algorithm>
#include <cassert>

namespace slicefarm::ordering {
namespace {

size_t Middle(size_t first, size_t last) { return first + (last - first) / 2; }

double Squared(double x) { return x * x; }

}  // namespace

PointTree::PointTree(std::span<const Vector2> points) : position_(points.size()) {
  nodes_.reserve(points.size());
  for (uint32_t i = 0; i < points.size(); ++i) {
    nodes_.push_back({points[i].x(), points[i].y(), i, 0, /*removed=*/false, /*split_x=*/true});
  }
  Build(0, nodes_.size());
  for (size_t i = 0; i < nodes_.size(); ++i) position_[nodes_[i].number] = static_cast<uint32_t>(i);
}

void PointTree::Build(size_t first, size_t last) {
  if (first == last) return;
  const auto begin = nodes_.begin() + static_cast<ptrdiff_t>(first);
  const auto end = nodes_.begin() + static_cast<ptrdiff_t>(last);
  const auto by_x = [](const Node& a, const Node& b) {
    return a.x < b.x || (a.x == b.x && a.number < b.number);
  };
  const auto by_y = [](const Node& a, const Node& b) {
    return a.y < b.y || (a.y == b.y && a.number < b.number);
  };
  const auto [min_x, max_x] = std::minmax_element(begin, end, by_x);
  const auto [min_y, max_y] = std::minmax_element(begin, end, by_y);
  const bool split_x = max_x->x - min_x->x >= max_y->y - min_y->y;
  const size_t middle = Middle(first, last);
  const auto at = nodes_.begin() + static_cast<ptrdiff_t>(middle);
  if (split_x) {
    std::nth_element(begin, at, end, by_x);
  } else {
    std::nth_element(begin, at, end, by_y);
  }
  nodes_[middle].split_x = split_x;
  nodes_[middle].alive = static_cast<uint32_t>(last - first);
  Build(first, middle);
  Build(middle + 1, last);
}

void PointTree::Remove(uint32_t number) {
  const size_t position = position_[number];
  assert(!nodes_[position].removed);
  nodes_[position].removed = true;
  Count(position, -1U);
}

void PointTree::Restore(uint32_t number) {
  const size_t position = position_[number];
  assert(nodes_[position].removed);
  nodes_[position].removed = false;
  Count(position, 1);
}

void PointTree::Count(size_t position, uint32_t more) {
  size_t first = 0;
  size_t last = nodes_.size();
  for (;;) {
    const size_t middle = Middle(first, last);
    nodes_[middle].alive += more;
    if (middle == position) return;
    (position < middle ? last : first) = position < middle ? middle : middle + 1;
  }
}

uint32_t PointTree::Nearest(Vector2 to) const {
  Candidate best{std::numeric_limits<double>::infinity(), kNone};
  SearchNearest(0, nodes_.size(), to.x(), to.y(), best);
  return best.number;
}

void PointTree::SearchNearest(size_t first, size_t last, double x, double y,
                              Candidate& best) const {
  if (first == last) return;
  const size_t middle = Middle(first, last);
  const Node& node = nodes_[middle];
  if (node.alive == 0) return;
  if (!node.removed) {
    const Candidate here{Squared(node.x - x) + Squared(node.y - y), node.number};
    if (here.Before(best)) best = here;
  }
  const double beyond = node.split_x ? x - node.x : y - node.y;
  const bool lower_first = beyond < 0;
  if (lower_first) SearchNearest(first, middle, x, y, best);
  if (!lower_first) SearchNearest(middle + 1, last, x, y, best);
  if (Squared(beyond) >= best.distance2) return;
  if (lower_first) SearchNearest(middle + 1, last, x, y, best);
  if (!lower_first) SearchNearest(first, middle, x, y, best);
}

void PointTree::NearestFew(Vector2 to, uint32_t except, size_t count, std::vector<uint32_t>& found,
                           std::optional<Quadrant> quadrant) const {
  found.clear();
  if (count == 0) return;
  FewQuery query{to.x(), to.y(), except, count, quadrant, {}};
  query.best.reserve(count + 1);
  SearchFew(0, nodes_.size(), query);
  for (const Candidate& candidate : query.best) found.push_back(candidate.number);
}

void PointTree::SearchFew(size_t first, size_t last, FewQuery& query) const {
  if (first == last) return;
  const size_t middle = Middle(first, last);
  const Node& node = nodes_[middle];
  if (node.alive == 0) return;
  if (query.Admits(node)) {
    const Candidate here{Squared(node.x - query.x) + Squared(node.y - query.y), node.number};
    const bool full = query.best.size() == query.count;
    if (!full || here.Before(query.best.back())) {
      if (full) query.best.pop_back();
      const auto at =
          std::upper_bound(query.best.begin(), query.best.end(), here,
                           [](const Candidate& a, const Candidate& b) { return a.Before(b); });
      query.best.insert(at, here);
    }
  }
  const double beyond = node.split_x ? query.x - node.x : query.y - node.y;
  const bool lower_first = beyond < 0;
  const auto search = [&](bool lower) {
    if (query.Skips(node, lower)) return;
    lower ? SearchFew(first, middle, query) : SearchFew(middle + 1, last, query);
  };
  search(lower_first);
  const bool full = query.best.size() == query.count;
  if (full && Squared(beyond) >= query.best.back().distance2) return;
  search(!lower_first);
}

}  // namespace slicefarm::ordering
