#pragma once

#include "services/motion/algo/firmware/numbered_objects.h"

namespace slicefarm::motion {

/// Common base of Marlin 2 and its forks.
class MarlinFirmware : public NumberedObjects {
 public:
  std::string_view name() const override { return "marlin2"; }

  std::unique_ptr<Planner> MakePlanner(const MachineLimits& limits) const override;
  double AccelerationFor(const KinematicMove& move, const MachineLimits& limits) const override;
  double ArcSegmentMm(double radius_mm, double speed_mm_s) const override;

  ExtruderMode extruder_mode() const override { return ExtruderMode::kWithAxes; }
  bool Knows(const GcodeLine& line) const override;
  void ApplyLimits(const GcodeLine& line, MachineLimits& limits) const override;

  void WriteLimits(const MachineLimits& limits, GcodeText& out) const override;
  bool HasTravelAcceleration() const override { return true; }
  void WriteAcceleration(double print_mm_s2, double travel_mm_s2, GcodeText& out) const override;
  void WriteJerk(std::span<const double, 4> jerk_mm_s, GcodeText& out) const override;
  bool HasJunctionDeviation() const override { return true; }
  void WriteJunctionDeviation(double deviation_mm, GcodeText& out) const override;

 protected:
  /// Writes the acceleration limits as M204.
  virtual void WriteAccelerationLimits(const MachineLimits& limits, GcodeText& out) const;
  /// Writes the minimum feed rates of printing (M205 S) and of travels (M205 T).
  virtual void WriteLeastRates(const MachineLimits& limits, GcodeText& out) const;
};

/// Marlin 2 and its forks, including Prusa's.
const Firmware& Marlin2();
/// Marlin 1: one acceleration for printing and travel.
const Firmware& MarlinLegacy();

}  // namespace slicefarm::motion
