#include "common/model/layers/fill_stats.h"

#include <algorithm>
#include <tuple>

namespace slicefarm {

void FillStats::Add(const FillStats& other, int64_t copies) {
  const auto times = static_cast<double>(copies);
  area_mm2 += times * other.area_mm2;
  volume_mm3 += times * other.volume_mm3;
  asked_mm3 += times * other.asked_mm3;
  plastic_mm3 += times * other.plastic_mm3;
  paths += copies * other.paths;
  length_mm += times * other.length_mm;
  if (copies > 0) longest_mm = std::max(longest_mm, other.longest_mm);
}

void AddUse(const FillStats& use, int64_t copies, std::vector<FillStats>& uses) {
  const auto kind = [](const FillStats& of) {
    return std::tuple(of.settings, of.feature, of.pattern);
  };
  auto same = std::ranges::lower_bound(uses, kind(use), {}, kind);
  if (same == uses.end() || kind(*same) != kind(use))
    same = uses.insert(same, {use.settings, use.feature, use.pattern});
  same->Add(use, copies);
}

}  // namespace slicefarm
