#include "services/lab/tours/first_tours.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace slicefarm::lab {
namespace {

using ordering::Costs;
using ordering::Tour;

constexpr int64_t kFar = std::numeric_limits<int64_t>::max();

}  // namespace

Tour NearestNeighbourTour(const Costs& costs, int32_t first) {
  Tour left(static_cast<size_t>(costs.size()));
  std::iota(left.begin(), left.end(), 0);
  std::erase(left, first);
  Tour tour = {first};
  while (!left.empty()) {
    const auto nearest =
        std::ranges::min_element(left, {}, [&](int32_t node) { return costs(tour.back(), node); });
    tour.push_back(*nearest);
    left.erase(nearest);
  }
  return tour;
}

Tour InsertionTour(const Costs& costs) {
  Tour left(static_cast<size_t>(costs.size() - 1));
  std::iota(left.begin(), left.end(), 1);
  std::vector<int64_t> away(static_cast<size_t>(costs.size()), kFar);  // distance from the tour
  Tour tour = {0};
  int32_t newest = 0;
  while (!left.empty()) {
    for (const int32_t node : left) {
      int64_t& distance = away[static_cast<size_t>(node)];
      distance = std::min(distance, costs(node, newest));
    }
    const auto farthest = std::ranges::max_element(
        left, {}, [&](int32_t node) { return away[static_cast<size_t>(node)]; });
    newest = *farthest;
    left.erase(farthest);
    size_t best = 0;
    int64_t least = kFar;
    for (size_t i = 0; i < tour.size(); ++i) {
      const int32_t a = tour[i];
      const int32_t b = tour[i + 1 < tour.size() ? i + 1 : 0];
      const int64_t longer = costs(a, newest) + costs(newest, b) - costs(a, b);
      if (longer >= least) continue;
      least = longer;
      best = i + 1;
    }
    tour.insert(tour.begin() + static_cast<ptrdiff_t>(best), newest);
  }
  return tour;
}

}  // namespace slicefarm::lab
