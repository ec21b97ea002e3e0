#include "services/beading/algo/arachne/neighbour_outlines.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::beading {

double NeighbourOutlines::MeanRadius(size_t i, size_t reach, double x, double y, double radius_nm,
                                     double band_nm) const {
  const size_t first = i > reach ? i - reach : 0;
  const size_t last = std::min(layers_.size(), i + reach + 1);
  double sum = radius_nm;
  int count = 1;
  for (size_t other = first; other < last; ++other) {
    if (other == i) continue;
    const double radius = IndexOf(other).DistanceFrom(x, y, radius_nm + band_nm);
    if (std::abs(radius - radius_nm) > band_nm) continue;
    sum += radius;
    ++count;
  }
  return sum / count;
}

const OutlineIndex& NeighbourOutlines::IndexOf(size_t i) const {
  if (!indexes_[i]) indexes_[i].emplace(*layers_[i]);
  return *indexes_[i];
}

}  // namespace slicefarm::beading
