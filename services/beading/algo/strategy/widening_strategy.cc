#include "services/beading/algo/strategy/widening_strategy.h"

#include <algorithm>

#include "services/beading/algo/strategy/bead_layout.h"

namespace slicefarm::beading {

Beading WideningStrategy::Compute(Coord thickness_nm, int count) const {
  if (count == 1 && thickness_nm >= options_.min_feature_nm && thickness_nm < options_.min_width_nm)
    return LayOut(thickness_nm, 1, {options_.min_width_nm});
  if (count == 1 && thickness_nm < options_.min_feature_nm) return LayOut(thickness_nm, 0, {});
  return parent_->Compute(thickness_nm, count);
}

int WideningStrategy::OptimalCount(Coord thickness_nm) const {
  if (thickness_nm < options_.min_feature_nm) return 0;
  return std::max(1, parent_->OptimalCount(thickness_nm));
}

Coord WideningStrategy::TransitionThickness(int lower_count) const {
  if (lower_count == 0) return options_.min_feature_nm;
  return std::max(options_.min_feature_nm, parent_->TransitionThickness(lower_count));
}

std::vector<Coord> WideningStrategy::Kinks() const {
  std::vector<Coord> kinks = parent_->Kinks();
  kinks.push_back(options_.min_width_nm);
  std::sort(kinks.begin(), kinks.end());
  return kinks;
}

}  // namespace slicefarm::beading
