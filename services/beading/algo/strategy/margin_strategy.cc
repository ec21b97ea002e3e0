#include "services/beading/algo/strategy/margin_strategy.h"

namespace slicefarm::beading {

Beading MarginStrategy::Compute(Coord thickness_nm, int count) const {
  const Coord inner = Inner(thickness_nm);
  Beading beading = parent_->Compute(inner, count);
  const Coord added = thickness_nm - inner;
  for (int i = 0; i < beading.count(); ++i) {
    Coord& location = beading.locations_nm[i];
    // Positions of the second half are rounded in the other direction, so that mirror images stay
    // exact.
    location += 2 * i < beading.count() ? added / 2 : added - added / 2;
  }
  beading.thickness_nm = thickness_nm;
  beading.left_over_nm += added;
  return beading;
}

Coord MarginStrategy::TransitionThickness(int lower_count) const {
  const Coord inner = parent_->TransitionThickness(lower_count);
  return inner == kUnreachableNm ? inner : inner + 2 * margin_nm_;
}

std::vector<Coord> MarginStrategy::Kinks() const {
  std::vector<Coord> kinks = parent_->Kinks();
  for (Coord& kink : kinks) kink += 2 * margin_nm_;
  return kinks;
}

}  // namespace slicefarm::beading
