#include "services/planning/algo/conflicts/near_copies.h"

#include <algorithm>
#include <vector>

namespace slicefarm::planning {
namespace {

/// Margin by which a bounding box grows beyond the new outline. With this margin an object that
/// grows slowly rarely needs a new sweep.
constexpr Coord kSpareNm = 2 * kNmPerMm;

struct Claimed {
  const PlacedCopy* copy = nullptr;
  Box box;
};

}  // namespace

void NearCopies::Claim(int32_t object, const Box& box) {
  if (copies_.size() < 2) return;
  Box& claim = claims_[object];
  Box together = claim;
  together.Add(box);
  if (together == claim) return;
  claim.Add(box.Grown(kSpareNm));
  stale_ = true;
}

const std::set<Beside>& NearCopies::Of(int32_t object) {
  if (stale_) Sweep();
  return near_[object];
}

void NearCopies::Sweep() {
  std::vector<Claimed> claims;
  for (const PlacedCopy& copy : copies_)
    if (const auto claim = claims_.find(copy.object); claim != claims_.end())
      claims.push_back({&copy, {claim->second.min + copy.shift, claim->second.max + copy.shift}});
  std::ranges::stable_sort(claims, {}, [](const Claimed& c) { return c.box.min.x; });
  for (size_t i = 0; i < claims.size(); ++i) {
    const auto& [a, box] = claims[i];
    for (size_t j = i + 1; j < claims.size() && claims[j].box.min.x <= box.max.x; ++j) {
      const PlacedCopy& b = *claims[j].copy;
      if (!box.Intersects(claims[j].box)) continue;
      near_[a->object].insert({b.object, b.shift - a->shift});
      near_[b.object].insert({a->object, a->shift - b.shift});
    }
  }
  stale_ = false;
}

}  // namespace slicefarm::planning
