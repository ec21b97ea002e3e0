#include "services/beading/algo/strategy/limited_strategy.h"

#include <algorithm>

namespace slicefarm::beading {
namespace {

/// Distance below the thickness at which one more bead would have its optimal width. From this
/// thickness on, the infill gets an area that it can fill.
constexpr Coord kShyNm = 10'000;

/// Adds a bead of width 0 at the inner edge of the first half's last bead. If `both`, also adds its
/// mirror image.
void AddMarkers(int per_half, bool both, Beading* beading) {
  const Coord border = beading->locations_nm[per_half - 1] + beading->widths_nm[per_half - 1] / 2;
  std::vector<Coord> places = {border};
  if (both) places.push_back(beading->thickness_nm - border);
  beading->locations_nm.insert(beading->locations_nm.begin() + per_half, places.begin(),
                               places.end());
  beading->widths_nm.insert(beading->widths_nm.begin() + per_half, places.size(), 0);
}

}  // namespace

Beading LimitedStrategy::Compute(Coord thickness_nm, int count) const {
  const int half = max_count_ / 2;
  if (count <= max_count_) {
    Beading beading = parent_->Compute(thickness_nm, count);
    if (count == max_count_ && half > 0) AddMarkers(half, false, &beading);
    return beading;
  }
  const Coord optimal = parent_->OptimalThickness(max_count_);
  // Only in a transition to fewer beads, `thickness_nm` is smaller than `optimal`.
  Beading beading = parent_->Compute(std::min(thickness_nm, optimal), max_count_);
  const Coord added = thickness_nm - beading.thickness_nm;
  for (int i = half; i < max_count_; ++i) beading.locations_nm[i] += added;
  beading.thickness_nm = thickness_nm;
  beading.left_over_nm += added;
  const Coord apart = std::clamp<Coord>(added / 2, 0, apart_nm_);
  for (int i = 1; i < half; ++i) {
    beading.locations_nm[i] += apart;
    beading.locations_nm[max_count_ - 1 - i] -= apart;
  }
  if (half > 0) AddMarkers(half, true, &beading);
  return beading;
}

int LimitedStrategy::OptimalCount(Coord thickness_nm) const {
  if (thickness_nm >= TransitionThickness(max_count_)) return max_count_ + 1;
  return std::min(parent_->OptimalCount(thickness_nm), max_count_);
}

Coord LimitedStrategy::OptimalThickness(int count) const {
  return parent_->OptimalThickness(std::min(count, max_count_ + 1));
}

Coord LimitedStrategy::TransitionThickness(int lower_count) const {
  if (lower_count < max_count_) return parent_->TransitionThickness(lower_count);
  if (lower_count > max_count_) return kUnreachableNm;
  return std::max(parent_->OptimalThickness(max_count_ + 1) - kShyNm,
                  max_count_ == 0 ? 0 : parent_->TransitionThickness(max_count_ - 1));
}

Coord LimitedStrategy::TransitionLength(int lower_count) const {
  return parent_->TransitionLength(std::min(lower_count, max_count_));
}

double LimitedStrategy::TransitionAnchor(int lower_count) const {
  return parent_->TransitionAnchor(std::min(lower_count, max_count_));
}

std::vector<Coord> LimitedStrategy::Kinks() const {
  std::vector<Coord> kinks = parent_->Kinks();
  kinks.push_back(parent_->OptimalThickness(max_count_));
  if (apart_nm_ > 0) kinks.push_back(kinks.back() + 2 * apart_nm_);
  std::sort(kinks.begin(), kinks.end());
  return kinks;
}

}  // namespace slicefarm::beading
