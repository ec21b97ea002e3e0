#include "services/ordering/algo/tours/neighbours.h"

#include <algorithm>
#include <optional>

#include "services/ordering/algo/tours/point_tree.h"

namespace slicefarm::ordering {
namespace {

bool Nearer(const Neighbour& a, const Neighbour& b) {
  return a.length < b.length || (a.length == b.length && a.node < b.node);
}

std::vector<Neighbour> NearestOfTable(const Costs& costs, int32_t node, size_t count) {
  std::vector<Neighbour> others;
  others.reserve(static_cast<size_t>(costs.size()));
  for (int32_t other = 0; other < costs.size(); ++other) {
    if (other != node && !costs.IsNowhere(other)) others.push_back({other, costs(node, other)});
  }
  if (others.size() > count) {
    std::nth_element(others.begin(), others.begin() + static_cast<ptrdiff_t>(count), others.end(),
                     Nearer);
    others.resize(count);
  }
  return others;
}

/// Search for the nearest points, in all directions together and per quadrant.
class NeighbourFinder {
 public:
  NeighbourFinder(const Costs& costs, std::span<const Vector2> points)
      : costs_(costs), tree_(points) {}

  std::vector<Neighbour> NearestOf(int32_t node, size_t count, size_t per_quadrant) {
    std::vector<Neighbour> found;
    Add(node, count, {}, found);
    if (per_quadrant == 0) return found;
    for (const bool right : {false, true}) {
      for (const bool above : {false, true})
        Add(node, per_quadrant, PointTree::Quadrant{right, above}, found);
    }
    return found;
  }

 private:
  void Add(int32_t node, size_t count, std::optional<PointTree::Quadrant> quadrant,
           std::vector<Neighbour>& found) {
    const auto self = static_cast<uint32_t>(node);
    tree_.NearestFew(costs_.points()[self], self, count, near_, quadrant);
    for (const uint32_t other : near_) {
      const auto same = [other](const Neighbour& known) {
        return known.node == static_cast<int32_t>(other);
      };
      if (std::ranges::any_of(found, same)) continue;
      found.push_back({static_cast<int32_t>(other), costs_(node, static_cast<int32_t>(other))});
    }
  }

  const Costs& costs_;
  PointTree tree_;
  std::vector<uint32_t> near_;
};

}  // namespace

Neighbours::Neighbours(const Costs& costs, size_t count, size_t per_quadrant) {
  const auto size = static_cast<size_t>(costs.size());
  const bool nowhere = size > 0 && costs.IsNowhere(costs.size() - 1);
  std::optional<NeighbourFinder> finder;
  if (costs.has_points())
    finder.emplace(costs, std::span(costs.points()).first(nowhere ? size - 1 : size));
  begin_.reserve(size + 1);
  all_.reserve(size * (count + 1));
  for (int32_t node = 0; node < costs.size(); ++node) {
    begin_.push_back(static_cast<uint32_t>(all_.size()));
    if (costs.IsNowhere(node)) continue;
    if (nowhere) all_.push_back({costs.size() - 1, 0});
    std::vector<Neighbour> near =
        finder ? finder->NearestOf(node, count, per_quadrant) : NearestOfTable(costs, node, count);
    std::ranges::sort(near, Nearer);
    all_.insert(all_.end(), near.begin(), near.end());
  }
  begin_.push_back(static_cast<uint32_t>(all_.size()));
}

}  // namespace slicefarm::ordering
