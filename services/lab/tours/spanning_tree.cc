#include "services/lab/tours/spanning_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace slicefarm::lab {
namespace {

using ordering::Costs;
using ordering::FixedEdges;
using ordering::NodePair;

constexpr int64_t kUnreached = std::numeric_limits<int64_t>::max();
/// Penalty units per length unit.
constexpr int64_t kScale = 256;
/// Number of iterations without a better bound after which steps are halved.
constexpr int kPatience = 5;

/// Runs Prim's algorithm over the nodes first .. size - 1. Calls `join(node, parent, length)` for
/// each node except `first`.
template <typename Length, typename Join>
void GrowTree(int32_t first, int32_t size, const Length& length, const Join& join) {
  struct Outside {
    int32_t node;
    int32_t parent;
    int64_t distance;
  };
  std::vector<Outside> outside;
  for (int32_t node = first + 1; node < size; ++node) outside.push_back({node, first, kUnreached});
  int32_t newest = first;
  while (!outside.empty()) {
    size_t nearest = 0;
    for (size_t i = 0; i < outside.size(); ++i) {
      Outside& other = outside[i];
      const int64_t distance = length(newest, other.node);
      if (distance < other.distance) {
        other.distance = distance;
        other.parent = newest;
      }
      if (other.distance < outside[nearest].distance) nearest = i;
    }
    const Outside joined = outside[nearest];
    outside[nearest] = outside.back();
    outside.pop_back();
    join(joined.node, joined.parent, joined.distance);
    newest = joined.node;
  }
}

/// Lengths with penalties. Fixed edges are shortened so much that every tree contains them. Every
/// tour has all fixed edges too, so Correction adds the same amount to the bound.
class Penalized {
 public:
  Penalized(const Costs& costs, std::span<const NodePair> fixed)
      : costs_(costs),
        fixed_(costs.size(), fixed),
        any_fixed_(!fixed.empty()),
        penalty_(static_cast<size_t>(costs.size()), 0) {
    for (const NodePair& edge : fixed) rebate_ = std::max(rebate_, kScale * costs(edge.a, edge.b));
    offset_ = rebate_ * static_cast<int64_t>(fixed.size());
  }

  int64_t operator()(int32_t a, int32_t b) const {
    const int64_t length = kScale * costs_(a, b) + Penalty(a) + Penalty(b);
    return any_fixed_ && fixed_.Has(a, b) ? length - rebate_ : length;
  }

  /// Returns the difference between a tour's length and its penalized length.
  int64_t Correction() const {
    return offset_ - 2 * std::accumulate(penalty_.begin(), penalty_.end(), int64_t{0});
  }

  void Raise(int32_t node, int64_t by) { penalty_[static_cast<size_t>(node)] += by; }

 private:
  int64_t Penalty(int32_t node) const { return penalty_[static_cast<size_t>(node)]; }

  const Costs& costs_;
  FixedEdges fixed_;
  bool any_fixed_;
  int64_t rebate_ = 0;
  int64_t offset_ = 0;
  std::vector<int64_t> penalty_;
};

struct OneTree {
  int64_t length = 0;
  std::vector<int> degree;
};

OneTree ShortestOneTree(const Penalized& lengths, int32_t size) {
  OneTree tree{0, std::vector<int>(static_cast<size_t>(size), 0)};
  const auto add = [&tree](int32_t a, int32_t b, int64_t length) {
    tree.length += length;
    ++tree.degree[static_cast<size_t>(a)];
    ++tree.degree[static_cast<size_t>(b)];
  };
  GrowTree(1, size, lengths, add);
  struct Near {
    int64_t length = kUnreached;
    int32_t node = 0;
  };
  Near nearest, second;
  for (int32_t node = 1; node < size; ++node) {
    const Near here{lengths(0, node), node};
    if (here.length < nearest.length) {
      second = nearest;
      nearest = here;
    } else if (here.length < second.length) {
      second = here;
    }
  }
  add(0, nearest.node, nearest.length);
  add(0, second.node, second.length);
  return tree;
}

/// Returns the sum of (degree - 2)^2 over all nodes, which is 0 for a tour.
int64_t Unevenness(const OneTree& tree) {
  int64_t sum = 0;
  for (const int degree : tree.degree) sum += int64_t{degree - 2} * (degree - 2);
  return sum;
}

int64_t RoundedUp(int64_t scaled) {
  return scaled / kScale + (scaled > 0 && scaled % kScale != 0 ? 1 : 0);
}

}  // namespace

SpanningTree MinimumSpanningTree(const Costs& costs) {
  SpanningTree tree;
  GrowTree(0, costs.size(), costs, [&tree](int32_t node, int32_t parent, int64_t length) {
    tree.edges.push_back({node, parent});
    tree.length += length;
  });
  return tree;
}

int64_t OneTreeBound(const Costs& costs, std::span<const NodePair> fixed,
                     const BoundOptions& options) {
  const int32_t size = costs.size();
  if (size < 3) return size < 2 ? 0 : 2 * costs(0, 1);
  Penalized lengths(costs, fixed);
  int64_t best = std::numeric_limits<int64_t>::min();
  double pace = 1;
  std::vector<int> before;
  int since_better = 0;
  for (int i = 0; i < options.iterations; ++i) {
    const OneTree tree = ShortestOneTree(lengths, size);
    const int64_t bound = tree.length + lengths.Correction();
    ++since_better;
    if (bound > best) {
      best = bound;
      since_better = 0;
    }
    const int64_t unevenness = Unevenness(tree);
    if (unevenness == 0) break;
    if (since_better >= kPatience) {
      pace /= 2;
      since_better = 0;
    }
    const double gap = static_cast<double>(kScale * options.upper_bound - bound);
    const double step = pace * std::max(gap, 0.0) / static_cast<double>(unevenness);
    if (before.empty()) before = tree.degree;
    for (int32_t node = 0; node < size; ++node) {
      const auto at = static_cast<size_t>(node);
      const double pull = 0.7 * (tree.degree[at] - 2) + 0.3 * (before[at] - 2);
      lengths.Raise(node, static_cast<int64_t>(step * pull));
    }
    before = tree.degree;
  }
  return RoundedUp(best);
}

}  // namespace slicefarm::lab
