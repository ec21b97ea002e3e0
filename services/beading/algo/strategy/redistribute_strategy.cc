#include "services/beading/algo/strategy/redistribute_strategy.h"

#include <algorithm>
#include <cmath>

#include "services/beading/algo/strategy/bead_layout.h"

namespace slicefarm::beading {
namespace {

/// Returns the widths of the first half of `beading`, with the whole middle bead.
std::vector<Coord> Half(const Beading& beading) {
  return {beading.widths_nm.begin(), beading.widths_nm.begin() + (beading.count() + 1) / 2};
}

}  // namespace

Beading RedistributeStrategy::Compute(Coord thickness_nm, int count) const {
  if (count == 0) return LayOut(thickness_nm, 0, {});
  if (count == 2 && options_.lock_outer_width && thickness_nm >= TransitionThickness(2))
    return LayOut(thickness_nm, count, {options_.outer_width_nm});
  if (count <= 2)
    return LayOut(thickness_nm, count, {std::min(thickness_nm / count, options_.max_width_nm)});
  const Coord least_inner = options_.min_width_nm * (count - 2);
  const Coord least = BothOuter() + least_inner;
  const Coord inner_thickness = std::max(thickness_nm, least) - BothOuter();
  std::vector<Coord> half = Half(parent_->Compute(inner_thickness, count - 2));
  half.insert(half.begin(), options_.outer_width_nm);
  if (thickness_nm < least) {
    const double scale = static_cast<double>(thickness_nm) / static_cast<double>(least);
    for (Coord& width : half)
      width = static_cast<Coord>(std::floor(static_cast<double>(width) * scale));
  }
  return LayOut(thickness_nm, count, half);
}

int RedistributeStrategy::OptimalCount(Coord thickness_nm) const {
  for (const int lower : {0, 1, 2})
    if (thickness_nm < TransitionThickness(lower)) return lower;
  return 2 + parent_->OptimalCount(thickness_nm - BothOuter());
}

Coord RedistributeStrategy::OptimalThickness(int count) const {
  if (count <= 2) return options_.outer_width_nm * count;
  return BothOuter() + parent_->OptimalThickness(count - 2);
}

Coord RedistributeStrategy::TransitionThickness(int lower_count) const {
  const auto outer = static_cast<double>(options_.outer_width_nm);
  if (lower_count == 0) return std::llround(options_.min_outer_share * outer);
  if (lower_count == 1) return std::llround((1 + options_.split_threshold) * outer);
  return BothOuter() + parent_->TransitionThickness(lower_count - 2);
}

Coord RedistributeStrategy::TransitionLength(int lower_count) const {
  return lower_count == 0 ? parent_->TransitionLength(0)
                          : parent_->TransitionLength(std::max(1, lower_count - 2));
}

double RedistributeStrategy::TransitionAnchor(int lower_count) const {
  const auto from = static_cast<double>(OptimalThickness(lower_count));
  const auto to = static_cast<double>(OptimalThickness(lower_count + 1));
  const double at = static_cast<double>(TransitionThickness(lower_count));
  return std::clamp(1 - (at - from) / (to - from), 0.0, 1.0);
}

std::vector<Coord> RedistributeStrategy::Kinks() const {
  std::vector<Coord> kinks = parent_->Kinks();
  for (Coord& kink : kinks) kink += BothOuter();
  return kinks;
}

}  // namespace slicefarm::beading
