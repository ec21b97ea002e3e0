#include "services/infill/algo/lines/strip_ramps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/geometry/measure.h"
#include "common/model/bead_section.h"

namespace slicefarm::infill {
namespace {

/// Largest relative change of a strip's width, over a length of `kRampPitches` pitches.
constexpr double kRampStep = 0.2;
constexpr double kRampPitches = 0.25;

/// Greatest length of a ramp, in steps.
constexpr int kRampSteps = 5;

/// Returns for each point of a bead the distance along it to the next point with a strip other than
/// the bead's first strip. The search is forward, or backward with `backwards`.
std::vector<double> TravelsToChange(const std::vector<StripPoint>& bead, bool backwards) {
  const size_t count = bead.size();
  std::vector<double> paths(count, std::numeric_limits<double>::infinity());
  for (size_t k = 0; k < count; ++k) {
    const size_t i = backwards ? k : count - 1 - k;
    if (bead[i].strip_nm != bead[0].strip_nm) {
      paths[i] = 0;
    } else if (k > 0) {
      const size_t last = backwards ? i - 1 : i + 1;
      if (std::isfinite(paths[last])) paths[i] = paths[last] + Distance(bead[i].at, bead[last].at);
    }
  }
  return paths;
}

/// Returns the bead with additional points wherever its strip changes or may have to change.
std::vector<StripPoint> WithRampPoints(const std::vector<StripPoint>& bead, double step_nm) {
  const std::vector<double> before = TravelsToChange(bead, true),
                            behind = TravelsToChange(bead, false);
  const double longest = kRampSteps * step_nm;
  std::vector<StripPoint> fine = {bead.front()};
  for (size_t i = 1; i < bead.size(); ++i) {
    const StripPoint &a = bead[i - 1], &b = bead[i];
    if (before[i - 1] > longest && behind[i] > longest) {
      if (b != a) fine.push_back(b);
      continue;
    }
    const double steps = Distance(a.at, b.at) / step_nm;
    const bool even = a.strip_nm == b.strip_nm;
    for (int k = 1; k < steps; ++k) {
      if (even && k > kRampSteps && k < steps - kRampSteps)
        k = static_cast<int>(steps) - kRampSteps;
      fine.push_back(Between(a, b, k / steps));
    }
    if (b != a) fine.push_back(b);
  }
  return fine;
}

/// Removes the points of `fine` between points of the same strip, except points of `bead`.
std::vector<StripPoint> WithoutNeedless(const std::vector<StripPoint>& fine,
                                        const std::vector<StripPoint>& bead) {
  std::vector<StripPoint> needed;
  size_t next = 0;
  for (size_t i = 0; i < fine.size(); ++i) {
    const bool own = next < bead.size() && fine[i].at == bead[next].at;
    while (next < bead.size() && fine[i].at == bead[next].at) ++next;
    const bool inside = i > 0 && i + 1 < fine.size() && fine[i - 1].strip_nm == fine[i].strip_nm &&
                        fine[i].strip_nm == fine[i + 1].strip_nm;
    if (own || !inside) needed.push_back(fine[i]);
  }
  return needed;
}

}  // namespace

std::vector<StripPoint> EvenRamps(const std::vector<StripPoint>& bead, double pitch_nm) {
  const auto changes = [&](const StripPoint& p) { return p.strip_nm != bead[0].strip_nm; };
  if (std::ranges::none_of(bead, changes)) return bead;
  const double step_nm = kRampPitches * pitch_nm;
  std::vector<StripPoint> even = WithRampPoints(bead, step_nm);
  const auto widen = [&](const StripPoint& from, StripPoint& to) {
    const double steps = Distance(from.at, to.at) / step_nm;
    to.strip_nm = std::max(to.strip_nm, from.strip_nm / (1 + kRampStep * steps));
  };
  for (size_t i = 1; i < even.size(); ++i) widen(even[i - 1], even[i]);
  for (size_t i = even.size(); i-- > 1;) widen(even[i], even[i - 1]);
  return WithoutNeedless(even, bead);
}

Path PathOfStrip(const std::vector<StripPoint>& bead, Coord height_nm) {
  Path path;
  for (const StripPoint& p : bead) {
    const Coord width_nm = WidthToFill(std::llround(p.strip_nm), height_nm);
    if (!path.points.empty() && path.points.back() == p.at && path.widths_nm.back() == width_nm)
      continue;
    path.points.push_back(p.at);
    path.widths_nm.push_back(width_nm);
  }
  if (std::ranges::count(path.widths_nm, path.widths_nm[0]) == std::ssize(path.widths_nm))
    path.widths_nm.resize(1);
  return path;
}

}  // namespace slicefarm::infill
