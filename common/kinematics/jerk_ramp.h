#pragma once

#include <array>
#include <span>

namespace slicefarm {

/// Acceleration and jerk limits along a path, in mm/s^2 and mm/s^3; both > 0.
struct RampLimits {
  double acceleration_mm_s2 = 0;
  double jerk_mm_s3 = 0;
};

// A ramp is a change of speed from v0 to v1 with zero acceleration at both ends. The acceleration
// rises at the largest jerk j, stays at its limit a if it reaches the limit, and falls. Let dv =
// |v1 - v0|, and T the duration. The length is (v0 + v1) / 2 T.
//   dv >= a^2 / j:  T = dv / a + a / j
//   dv < a^2 / j:   T = 2 sqrt(dv / j); the acceleration peaks at sqrt(j dv)

/// Returns the time of a ramp in s. `change_mm_s`: >= 0.
double RampTime(double change_mm_s, const RampLimits& limits);

/// Returns the length of a ramp in mm.
double RampLength(double from_mm_s, double to_mm_s, const RampLimits& limits);

/// Returns the greatest speed that a ramp of `length_mm` reaches from `from_mm_s`. By symmetry, a
/// ramp of this length can also slow down from this speed to `from_mm_s`. The speed is the positive
/// root of a quadratic equation. If the acceleration peaks below its limit, the speed is v0 + x^2,
/// with the root x of x^3 + 2 v0 x = length sqrt(j).
double SpeedAfter(double from_mm_s, double length_mm, const RampLimits& limits);

/// Phase of constant jerk in a profile. `time_s` is its duration; speed and acceleration are the
/// values at its start.
struct JerkPhase {
  double time_s = 0;
  double speed_mm_s = 0;
  double acceleration_mm_s2 = 0;
  double jerk_mm_s3 = 0;

  /// Returns the length covered at time t after the start of the phase.
  double LengthAt(double t) const;
  /// Returns the speed at time t after the start of the phase.
  double SpeedAt(double t) const;
};

/// Speed profile of a path in up to seven phases: a ramp up, a part at constant speed, and a ramp
/// down.
class JerkProfile {
 public:
  /// Makes the fastest profile up to `top_mm_s`. If the path is too short for this speed, the peak
  /// is the speed from which the exit speed can just be reached. REQUIRES: entry and exit speed are
  /// at most the top speed, and the path is long enough for a ramp between them.
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

/// Returns time and speed at positions along a profile. Positions must be requested in ascending
/// order.
class ProfileWalk {
 public:
  /// Starts at the beginning of the profile. REQUIRES: `profile` outlives this object.
  explicit ProfileWalk(const JerkProfile& profile) : phases_(profile.phases()) {}

  /// Time and speed at a position.
  struct Passing {
    double time_s = 0;
    double speed_mm_s = 0;
  };
  /// Returns time and speed at a position. `move_mm`: distance from the start of the path, in mm;
  /// not less than in the previous call.
  Passing At(double move_mm);

 private:
  std::span<const JerkPhase> phases_;
  double phase_start_s_ = 0;
  double phase_start_mm_ = 0;
  double in_phase_s_ = 0;
};

}  // namespace slicefarm
