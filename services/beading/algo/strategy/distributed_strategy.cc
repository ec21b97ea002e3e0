#include "services/beading/algo/strategy/distributed_strategy.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "services/beading/algo/strategy/bead_layout.h"

namespace slicefarm::beading {
namespace {

/// Transition length between no bead and the first one. It is short, because a first bead simply
/// ends.
constexpr Coord kFirstTransitionNm = 10'000;

int HalfCount(int count) { return (count + 1) / 2; }

/// Returns, for each bead of one half, its share of the excess. The shares of all beads of both
/// halves sum up to 1.
std::vector<double> Shares(int count, int distribution_count) {
  std::vector<double> shares(HalfCount(count));
  const double middle = (count - 1) / 2.0;
  const double reach = std::max(1, distribution_count);
  double sum = 0;
  for (int i = 0; i < HalfCount(count); ++i) {
    const double from_middle = (middle - i) / reach;
    shares[i] = std::max(0.0, 1 - from_middle * from_middle);
    sum += i == middle ? shares[i] : 2 * shares[i];
  }
  for (double& share : shares) share /= sum;
  return shares;
}

/// Widths of a half at one breakpoint of the thickness. Between two breakpoints the widths are
/// linear.
struct Breakpoint {
  double thickness = 0;
  std::vector<double> widths;
};

Breakpoint AllOf(double width, int count) {
  return {width * count, std::vector(HalfCount(count), width)};
}

/// Returns the stop at which the middle bead has `middle_width` and the other beads follow by their
/// shares.
Breakpoint MiddleOf(double middle_width, int count, double optimal,
                    const std::vector<double>& shares) {
  const double excess = (middle_width - optimal) / shares.back();
  Breakpoint stop{optimal * count + excess, {}};
  for (const double share : shares) stop.widths.push_back(optimal + excess * share);
  return stop;
}

}  // namespace

Beading DistributedStrategy::Compute(Coord thickness_nm, int count) const {
  if (count == 0) return LayOut(thickness_nm, 0, {});
  const auto optimal = static_cast<double>(options_.optimal_width_nm);
  const auto least = static_cast<double>(options_.min_width_nm);
  const auto most = static_cast<double>(options_.max_width_nm);
  const std::vector<double> shares = Shares(count, options_.distribution_count);
  const std::array<Breakpoint, 5> stops = {
      AllOf(0, count), AllOf(least, count), MiddleOf(least, count, optimal, shares),
      MiddleOf(most, count, optimal, shares), AllOf(most, count)};
  const auto thickness = static_cast<double>(thickness_nm);
  size_t above = 1;
  while (above + 1 < stops.size() && thickness > stops[above].thickness) ++above;
  const Breakpoint &low = stops[above - 1], &high = stops[above];
  const double span = high.thickness - low.thickness;
  const double t = span > 0 ? std::clamp((thickness - low.thickness) / span, 0.0, 1.0) : 1;
  std::vector<Coord> widths;
  Coord rest = thickness_nm;
  for (int i = 0; i < HalfCount(count); ++i) {
    const bool middle = 2 * i + 1 == count;
    const auto exact = std::llround(low.widths[i] + t * (high.widths[i] - low.widths[i]));
    // The innermost bead takes the rounding remainder, unless it has the largest width already.
    const bool innermost = i + 1 == HalfCount(count);
    const Coord to_fill = middle ? rest : rest / 2;
    widths.push_back(innermost ? std::clamp<Coord>(to_fill, 0, options_.max_width_nm) : exact);
    rest -= (middle ? 1 : 2) * widths.back();
  }
  return LayOut(thickness_nm, count, widths);
}

int DistributedStrategy::OptimalCount(Coord thickness_nm) const {
  const auto whole = static_cast<int>(thickness_nm / options_.optimal_width_nm);
  return thickness_nm >= TransitionThickness(whole) ? whole + 1 : whole;
}

Coord DistributedStrategy::OptimalThickness(int count) const {
  return options_.optimal_width_nm * count;
}

Coord DistributedStrategy::TransitionThickness(int lower_count) const {
  const double threshold = lower_count % 2 == 1 ? options_.split_threshold : options_.add_threshold;
  return OptimalThickness(lower_count) +
         std::llround(threshold * static_cast<double>(options_.optimal_width_nm));
}

Coord DistributedStrategy::TransitionLength(int lower_count) const {
  return lower_count == 0 ? kFirstTransitionNm : options_.transition_length_nm;
}

double DistributedStrategy::TransitionAnchor(int lower_count) const {
  const auto from = static_cast<double>(OptimalThickness(lower_count));
  const auto to = static_cast<double>(OptimalThickness(lower_count + 1));
  return 1 - (static_cast<double>(TransitionThickness(lower_count)) - from) / (to - from);
}

}  // namespace slicefarm::beading
