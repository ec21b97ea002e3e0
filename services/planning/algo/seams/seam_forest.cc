#include "services/planning/algo/seams/seam_forest.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slicefarm::planning {
namespace {

size_t FirstLeast(const std::vector<double>& costs) {
  return static_cast<size_t>(std::ranges::min_element(costs) - costs.begin());
}

/// Returns the square of the sideways part of a step, in mm^2.
double Sideways2(double step_mm, double away_mm) {
  return std::max(step_mm * step_mm - away_mm * away_mm, 0.0);
}

/// Smallest cost of a node and of all rings above it, for each point of its parent. `best`: index
/// of the node's point with this cost.
struct Message {
  std::vector<double> costs;
  std::vector<int32_t> best;
};

/// Returns the indices of the points, sorted from left to right. Points with equal x keep their
/// order.
std::vector<int32_t> ByX(const std::vector<Point>& candidates) {
  std::vector<int32_t> order(candidates.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {},
                           [&](int32_t p) { return candidates[static_cast<size_t>(p)].x; });
  return order;
}

/// Computes the message of a node to its parent. `costs`: for each point of the node, the cost of
/// the node and of all rings above it. A step goes to a point near the parent's point, or jumps to
/// the cheapest point of all.
Message Below(const SeamNode& node, const std::vector<double>& costs, const SeamNode& parent,
              const StepCost& step) {
  const auto x_of = [&](int32_t p) { return node.candidates[static_cast<size_t>(p)].x; };
  const std::vector<int32_t> by_x = ByX(node.candidates);
  const auto cheapest = static_cast<int32_t>(FirstLeast(costs));
  const auto away_of = [&](size_t p) { return node.away_mm.empty() ? 0 : node.away_mm[p]; };
  const double most_away = node.away_mm.empty() ? 0 : std::ranges::max(node.away_mm);
  const Coord reach = FromMm(step.longest_mm + most_away);
  const size_t count = parent.candidates.size();
  Message message{std::vector<double>(count, costs[static_cast<size_t>(cheapest)] + step.jump),
                  std::vector<int32_t>(count, cheapest)};
  for (size_t q = 0; q < count; ++q) {
    const Point from = parent.candidates[q];
    double& best = message.costs[q];
    int32_t& candidate = message.best[q];
    for (auto p = std::ranges::lower_bound(by_x, from.x - reach, {}, x_of);
         p != by_x.end() && x_of(*p) <= from.x + reach; ++p) {
      const auto at = static_cast<size_t>(*p);
      const double cost = costs[at] + step.Of(from, node.candidates[at], away_of(at));
      if (cost > best || (cost == best && *p > candidate)) continue;
      best = cost;
      candidate = *p;
    }
  }
  return message;
}

}  // namespace

bool StepCost::Reaches(Point from, Point to, double away_mm) const {
  return Sideways2(ToMm(Distance(from, to)), away_mm) <= longest_mm * longest_mm;
}

double StepCost::Of(Point from, Point to, double away_mm) const {
  const double mm = ToMm(Distance(from, to));
  const double sideways2 = Sideways2(mm, away_mm);
  if (sideways2 > longest_mm * longest_mm) return jump;
  return std::min(per_mm * mm + per_mm2_sideways * sideways2, jump);
}

std::vector<int32_t> CheapestSeams(std::span<const SeamNode> nodes, const StepCost& step) {
  std::vector<std::vector<double>> costs(nodes.size());  // cost of the tree above each node
  std::vector<std::vector<int32_t>> best(nodes.size());  // best place for each place of the parent
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
