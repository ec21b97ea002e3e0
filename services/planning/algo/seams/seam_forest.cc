#include "services/planning/algo/seams/seam_forest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace slicefarm::planning {
namespace {

size_t FirstLeast(const std::vector<double>& costs) {
  return static_cast<size_t>(std::ranges::min_element(costs) - costs.begin());
}

/// What the tree above a node comes to, by the place of its parent; and the node's place for each.
struct Message {
  std::vector<double> costs;
  std::vector<int32_t> best;
};

/// The places from the cheapest on; the first of equals first.
std::vector<size_t> ByCost(const std::vector<double>& costs) {
  std::vector<size_t> order(costs.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::stable_sort(order, {}, [&](size_t place) { return costs[place]; });
  return order;
}

/// `costs`: of the tree from `node` up, by its place.
Message Below(const SeamNode& node, const std::vector<double>& costs, const SeamNode& parent,
              const StepCost& step) {
  const std::vector<size_t> order = ByCost(costs);
  const size_t count = parent.places.size();
  Message message{std::vector<double>(count), std::vector<int32_t>(count)};
  for (size_t q = 0; q < count; ++q) {
    double best = std::numeric_limits<double>::infinity();
    size_t place = order.front();
    for (const size_t p : order) {
      if (costs[p] > best) break;  // and so are all that follow
      const double cost = costs[p] + step.Of(parent.places[q], node.places[p]);
      if (cost > best || (cost == best && p > place)) continue;
      best = cost;
      place = p;
    }
    message.costs[q] = best;
    message.best[q] = static_cast<int32_t>(place);
  }
  return message;
}

}  // namespace

double StepCost::Of(Point from, Point to) const {
  const double mm = ToMm(Distance(from, to));
  return mm <= longest_mm ? per_mm * mm : jump;
}

std::vector<int32_t> CheapestSeams(std::span<const SeamNode> nodes, const StepCost& step) {
  std::vector<std::vector<double>> costs(nodes.size());  // of the trees from each node up
  std::vector<std::vector<int32_t>> best(nodes.size());  // place, by that of the parent
  for (size_t i = 0; i < nodes.size(); ++i) costs[i] = nodes[i].costs;
  std::vector<int32_t> chosen(nodes.size(), 0);
  for (size_t i = nodes.size(); i-- > 0;) {
    if (nodes[i].parent < 0) {
      chosen[i] = static_cast<int32_t>(FirstLeast(costs[i]));
    } else {
      const auto parent = static_cast<size_t>(nodes[i].parent);
      Message message = Below(nodes[i], costs[i], nodes[parent], step);
      for (size_t q = 0; q < message.costs.size(); ++q) costs[parent][q] += message.costs[q];
      best[i] = std::move(message.best);
    }
    costs[i] = {};
  }
  for (size_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].parent < 0) continue;
    const int32_t below = chosen[static_cast<size_t>(nodes[i].parent)];
    chosen[i] = best[i][static_cast<size_t>(below)];
  }
  return chosen;
}

}  // namespace slicefarm::planning
