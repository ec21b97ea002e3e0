#include "services/infill/algo/linking/part_beside.h"

#include <algorithm>
#include <cmath>

#include "common/geometry/measure.h"

namespace slicefarm::infill {
namespace {

/// Sine of the largest angle between beads that count as parallel.
constexpr double kMostSine = 0.342;

/// Part of the interval from 0 to 1.
struct Share {
  double from = 0;
  double to = 1;
};

/// Reduces `share` to the part where a linear function is between two values. The function has the
/// values `at_from` at 0 and `at_to` at 1.
void Narrow(double at_from, double at_to, double low, double high, Share& share) {
  const double rise = at_to - at_from;
  if (rise == 0) {
    if (at_from < low || at_from > high) share.to = share.from - 1;
    return;
  }
  const auto [first, last] = std::minmax({(low - at_from) / rise, (high - at_from) / rise});
  share.from = std::max(share.from, first);
  share.to = std::min(share.to, last);
}

}  // namespace

std::optional<SegmentPart> PartBeside(Point a, Point b, Point c, Point d, double near_nm) {
  const Point path = b - a, run = d - c;
  const double length_nm = Distance(a, b), run_nm = Distance(c, d);
  if (length_nm == 0 || run_nm == 0 || std::abs(Cross(path, run)) > kMostSine * length_nm * run_nm)
    return std::nullopt;
  const double along0 = Dot(path, c - a) / length_nm;
  const double along1 = Dot(path, d - a) / length_nm;
  Share share;  // share of cd
  Narrow(Cross(path, c - a) / length_nm, Cross(path, d - a) / length_nm, -near_nm, near_nm, share);
  Narrow(along0, along1, 0, length_nm, share);
  if (share.from >= share.to) return std::nullopt;
  const auto [from, to] =
      std::minmax({along0 + share.from * (along1 - along0), along0 + share.to * (along1 - along0)});
  return SegmentPart{from, to};
}

}  // namespace slicefarm::infill
