#include "services/beading/algo/strategy/inset_strategy.h"

#include <algorithm>

namespace slicefarm::beading {

Beading InsetStrategy::Moved(Coord thickness_nm, int count, int first, int last) const {
  Beading beading = parent_->Compute(thickness_nm, count);
  const int half = beading.count() / 2;  // a middle bead is not moved
  for (int i = first; i < std::min(last, half); ++i) {
    Coord& location = beading.locations_nm[i];
    location = std::min(location + inset_nm_, thickness_nm / 2);
    beading.locations_nm[beading.count() - 1 - i] = thickness_nm - location;
  }
  return beading;
}

}  // namespace slicefarm::beading
