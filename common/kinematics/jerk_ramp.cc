#include "common/kinematics/jerk_ramp.h"

#include <algorithm>
#include <cmath>

namespace slicefarm {
namespace {

constexpr int kMostSteps = 100;
constexpr double kPrecision = 1e-14;
/// Share of a length or time below which it is only a rounding error.
constexpr double kNothing = 1e-11;

/// Returns the root of x^3 + 2 v0 x = c, by Newton's steps from above.
double RootOfCubic(double v0, double c, double upper) {
  double x = v0 > 0 ? std::min(upper, c / (2 * v0)) : upper;
  for (int i = 0; i < kMostSteps && x > 0; ++i) {
    const double next = (2 * x * x * x + c) / (3 * x * x + 2 * v0);
    if (next >= x * (1 - kPrecision)) break;
    x = next;
  }
  return x;
}

/// Returns the peak speed at which the ramps up and down exactly fill the length. It uses the
/// secant of two bounds; if a bound is kept twice, its value is halved (Illinois method).
double PeakSpeed(double length_mm, double entry, double top, double exit,
                 const RampLimits& limits) {
  const auto too_long = [&](double peak) {
    return RampLength(entry, peak, limits) + RampLength(peak, exit, limits) - length_mm;
  };
  double high = top, at_high = too_long(top);
  if (at_high <= 0) return top;
  if (entry == exit) return SpeedAfter(entry, length_mm / 2, limits);
  double low = std::max(entry, exit), at_low = too_long(low);
  if (at_low >= 0) return low;
  int side = 0;
  for (int i = 0; i < kMostSteps && high - low > kPrecision * high; ++i) {
    const double middle = (low * at_high - high * at_low) / (at_high - at_low);
    const double at_middle = too_long(middle);
    if (std::abs(at_middle) <= kPrecision * length_mm) return middle;
    if (at_middle > 0) {
      high = middle, at_high = at_middle;
      if (side == 1) at_low /= 2;
      side = 1;
    } else {
      low = middle, at_low = at_middle;
      if (side == -1) at_high /= 2;
      side = -1;
    }
  }
  return low;
}

}  // namespace

double RampTime(double change, const RampLimits& limits) {
  const double a = limits.acceleration_mm_s2, j = limits.jerk_mm_s3;
  return change * j >= a * a ? change / a + a / j : 2 * std::sqrt(change / j);
}

double RampLength(double from, double to, const RampLimits& limits) {
  return (from + to) / 2 * RampTime(std::abs(to - from), limits);
}

double SpeedAfter(double from, double length_mm, const RampLimits& limits) {
  const double a = limits.acceleration_mm_s2, j = limits.jerk_mm_s3;
  const double full = a * a / j;  // least change at which the acceleration reaches its limit
  if (length_mm < RampLength(from, from + full, limits)) {
    const double x = RootOfCubic(from, length_mm * std::sqrt(j), std::sqrt(full));
    return from + x * x;
  }
  const double b = from / a + a / (2 * j), c = from * a / j - length_mm;
  return from + a * (std::sqrt(b * b - 2 * c / a) - b);
}

double JerkPhase::LengthAt(double t) const {
  return t * (speed_mm_s + t * (acceleration_mm_s2 / 2 + t * jerk_mm_s3 / 6));
}

double JerkPhase::SpeedAt(double t) const {
  return speed_mm_s + t * (acceleration_mm_s2 + t * jerk_mm_s3 / 2);
}

JerkProfile::JerkProfile(double length_mm, double entry, double top, double exit,
                         const RampLimits& limits)
    : peak_mm_s_(PeakSpeed(length_mm, entry, top, exit, limits)) {
  const double ramps_mm =
      RampLength(entry, peak_mm_s_, limits) + RampLength(peak_mm_s_, exit, limits);
  AddRamp(entry, peak_mm_s_, limits);
  const double even_mm = length_mm - ramps_mm;
  if (even_mm > kNothing * length_mm) Add(even_mm / peak_mm_s_, peak_mm_s_, 0, 0);
  AddRamp(peak_mm_s_, exit, limits);
}

void JerkProfile::AddRamp(double from, double to, const RampLimits& limits) {
  const double change = std::abs(to - from), sign = to > from ? 1 : -1;
  if (change == 0) return;
  const double j = limits.jerk_mm_s3;
  const double a = std::min(limits.acceleration_mm_s2, std::sqrt(j * change));
  const double rise_s = a / j, bend = sign * a * a / (2 * j);
  const double even_s = std::max(0.0, change / a - rise_s);
  Add(rise_s, from, 0, sign * j);
  if (even_s > kNothing * rise_s) Add(even_s, from + bend, sign * a, 0);
  Add(rise_s, to - bend, sign * a, -sign * j);
}

void JerkProfile::Add(double time_s, double speed, double acceleration, double jerk) {
  phases_[count_++] = {time_s, speed, acceleration, jerk};
  time_s_ += time_s;
}

ProfileWalk::Passing ProfileWalk::At(double move_mm) {
  while (phases_.size() > 1) {
    const double end_mm = phase_start_mm_ + phases_.front().LengthAt(phases_.front().time_s);
    if (move_mm <= end_mm) break;
    phase_start_mm_ = end_mm;
    phase_start_s_ += phases_.front().time_s;
    in_phase_s_ = 0;
    phases_ = phases_.subspan(1);
  }
  if (phases_.empty()) return {};
  const JerkPhase& phase = phases_.front();
  const double path = move_mm - phase_start_mm_;
  // The position increases with time: Newton's step, or bisection if the step leaves the bounds.
  double low = in_phase_s_, high = phase.time_s, t = low;
  for (int i = 0; i < kMostSteps && high - low > kPrecision * phase.time_s; ++i) {
    const double off = phase.LengthAt(t) - path;
    if (std::abs(off) <= kPrecision * (path + 1)) break;
    (off < 0 ? low : high) = t;
    const double speed = phase.SpeedAt(t);
    const double next = t - off / speed;
    t = speed > 0 && next > low && next < high ? next : (low + high) / 2;
  }
  in_phase_s_ = t;
  return {phase_start_s_ + t, std::max(0.0, phase.SpeedAt(t))};
}

}  // namespace slicefarm
