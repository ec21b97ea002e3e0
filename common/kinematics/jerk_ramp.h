#pragma once

#include <array>
#include <span>

namespace slicefarm {

/// What a machine's motors can do along a way: mm/s^2, mm/s^3; both > 0.
struct RampLimits {
  double acceleration_mm_s2 = 0;
  double jerk_mm_s3 = 0;
};

// A ramp goes from one speed to another with no acceleration at either end: the acceleration rises
// at the greatest jerk, stays at its limit if it gets there, and falls. With dv the change of
// speed:
//   dv >= a^2 / j:  T = dv / a + a / j;   else it peaks at sqrt(j dv):  T = 2 sqrt(dv / j);
//   length = (v0 + v1) / 2 T.

/// Time in s. `change_mm_s`: >= 0.
double RampTime(double change_mm_s, const RampLimits& limits);

/// Way in mm.
double RampLength(double from_mm_s, double to_mm_s, const RampLimits& limits);

/// The greatest speed that a ramp reaches from `from_mm_s` on `length_mm` (as well: from which it
/// slows down to that): the positive root of a quadratic or, where the acceleration peaks below its
/// limit, of x^3 + 2 v0 x = length sqrt(j), x^2 = dv.
double SpeedAfter(double from_mm_s, double length_mm, const RampLimits& limits);

/// One of the up to seven parts of a move in which the jerk does not change; values are those at
/// its start.
struct JerkPhase {
  double time_s = 0;
  double speed_mm_s = 0;
  double acceleration_mm_s2 = 0;
  double jerk_mm_s3 = 0;

  double LengthAt(double t) const;
  double SpeedAt(double t) const;
};

/// A way with a ramp up, a stretch of even speed and a ramp down.
class JerkProfile {
 public:
  /// As fast as `top_mm_s` allows or, where the way is too short for that, up to the speed from
  /// which the exit can just be reached. REQUIRES: speeds not above the top; the ramp between them
  /// fits.
  JerkProfile(double length_mm, double entry_mm_s, double top_mm_s, double exit_mm_s,
              const RampLimits& limits);

  double time_s() const { return time_s_; }
  double peak_mm_s() const { return peak_mm_s_; }
  std::span<const JerkPhase> phases() const { return std::span(phases_).first(count_); }

 private:
  void AddRamp(double from_mm_s, double to_mm_s, const RampLimits& limits);
  void Add(double time_s, double speed_mm_s, double acceleration_mm_s2, double jerk_mm_s3);

  std::array<JerkPhase, 7> phases_;
  size_t count_ = 0;
  double peak_mm_s_ = 0;
  double time_s_ = 0;
};

/// When and how fast a profile passes places along its way, which must be asked for in their order.
class ProfileWalk {
 public:
  /// `profile` must live on.
  explicit ProfileWalk(const JerkProfile& profile) : phases_(profile.phases()) {}

  struct Passing {
    double time_s = 0;
    double speed_mm_s = 0;
  };
  Passing At(double way_mm);

 private:
  std::span<const JerkPhase> phases_;
  double phase_start_s_ = 0;
  double phase_start_mm_ = 0;
  double in_phase_s_ = 0;
};

}  // namespace slicefarm
