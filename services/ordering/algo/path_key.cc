#include "services/ordering/algo/path_key.h"

#include <algorithm>
#include <tuple>

namespace slicefarm::ordering {
namespace {

struct Keyed {
  Point least;
  const Path* path;
  size_t index;
};

bool Before(const Keyed& a, const Keyed& b) {
  if (a.least != b.least) return a.least < b.least;
  const auto facts = [](const Path& path) {
    return std::tuple(path.inset, path.feature, path.settings, path.tool, path.closed,
                      path.reversible, path.points.size());
  };
  if (facts(*a.path) != facts(*b.path)) return facts(*a.path) < facts(*b.path);
  return std::tie(a.path->points, a.path->widths_nm) < std::tie(b.path->points, b.path->widths_nm);
}

}  // namespace

Point LeastPoint(const Path& path) {
  return *std::min_element(path.points.begin(), path.points.end());
}

std::vector<size_t> OrderByGeometry(std::span<Path* const> paths) {
  std::vector<Keyed> keyed;
  keyed.reserve(paths.size());
  for (size_t i = 0; i < paths.size(); ++i) keyed.push_back({LeastPoint(*paths[i]), paths[i], i});
  std::sort(keyed.begin(), keyed.end(), Before);
  std::vector<size_t> order;
  order.reserve(paths.size());
  for (const Keyed& key : keyed) order.push_back(key.index);
  return order;
}

std::vector<Path*> SortedByGeometry(std::span<Path* const> paths) {
  std::vector<Path*> sorted;
  sorted.reserve(paths.size());
  for (const size_t index : OrderByGeometry(paths)) sorted.push_back(paths[index]);
  return sorted;
}

}  // namespace slicefarm::ordering
