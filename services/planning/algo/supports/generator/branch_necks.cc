#include "services/planning/algo/supports/generator/branch_necks.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slicefarm::planning {
namespace {

constexpr int kMostNecks = 2;

struct NeckPair {
  Coord gap_nm = 0;
  BranchNeck neck;

  friend auto operator<=>(const NeckPair&, const NeckPair&) = default;
};

/// Returns the pairs of discs that are close enough, the narrowest gaps first.
std::vector<NeckPair> NearPairs(std::span<const BranchDisc> discs) {
  Coord largest = 0;
  for (const BranchDisc& disc : discs) largest = std::max(largest, disc.radius_nm);
  std::vector<NeckPair> pairs;
  for (size_t a = 0; a < discs.size(); ++a) {
    const Coord reach = discs[a].radius_nm + largest + kMostNeckGapNm;
    for (size_t b = a + 1; b < discs.size() && discs[b].at.x - discs[a].at.x <= reach; ++b) {
      const Coord path = std::llround(Distance(discs[a].at, discs[b].at));
      const Coord gap = path - discs[a].radius_nm - discs[b].radius_nm;
      const bool inside = path <= std::abs(discs[a].radius_nm - discs[b].radius_nm);
      if (!inside && gap <= kMostNeckGapNm) pairs.push_back({gap, {a, b}});
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Chains of discs, stored as a forest of their indices.
class Strings {
 public:
  explicit Strings(size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), size_t{0});
  }

  /// Joins the chains of both discs. Returns false if both are already in one chain.
  bool Join(size_t a, size_t b) {
    const size_t root_a = Root(a), root_b = Root(b);
    if (root_a == root_b) return false;
    parent_[root_a] = root_b;
    return true;
  }

 private:
  size_t Root(size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::vector<size_t> parent_;
};

}  // namespace

std::vector<BranchNeck> NecksBetween(std::span<const BranchDisc> discs) {
  std::vector<int> count(discs.size(), 0);
  Strings strings(discs.size());
  std::vector<BranchNeck> necks;
  for (const auto& [gap, neck] : NearPairs(discs)) {
    if (count[neck.a] == kMostNecks || count[neck.b] == kMostNecks) continue;
    if (!strings.Join(neck.a, neck.b)) continue;
    ++count[neck.a];
    ++count[neck.b];
    necks.push_back(neck);
  }
  return necks;
}

Polygon OutlineOfNeck(const BranchDisc& a, const BranchDisc& b) {
  const Point path = b.at - a.at;
  const double half = static_cast<double>(std::min({a.radius_nm, b.radius_nm, kHalfNeckNm}));
  const double share = half / Distance(a.at, b.at);
  const Point left = {std::llround(-share * static_cast<double>(path.y)),
                      std::llround(share * static_cast<double>(path.x))};
  return {a.at - left, b.at - left, b.at + left, a.at + left};
}

}  // namespace slicefarm::planning
