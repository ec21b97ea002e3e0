#pragma once

#include <optional>

#include "common/model/options/flow_fit.h"
#include "common/model/path.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Speeds of paths in mm/s, by the settings of their region: the speed of the feature, of small
/// walls, and of the first layer on the bed or on a raft. Over the first slow_down_layers, speeds
/// grow from the first layer's speed. A feature without a speed setting gets max_print_speed.
/// max_volumetric_speed limits all speeds. `section_mm2`: section of the bead, flow included.
class PrintSpeeds {
 public:
  /// `layer`: index of the layer, for slow_down_layers.
  PrintSpeeds(const MotionOptions& options, Ground ground, int32_t layer = 1 << 30);

  /// Returns the speed of a path without the limit of the volumetric flow. `length_mm`: for a wall,
  /// the length of its contour (contour_length.h). REQUIRES: Path::settings is a valid index.
  double Of(const Path& path, double length_mm) const;
  /// Returns the reduced speed of a wall that is only partly supported. `rest`: supported share of
  /// the width, in percent.
  double OverAir(const Path& path, double speed_mm_s, uint8_t rest) const;
  /// Returns the largest volumetric flow of a bead in mm^3/s; infinity: no limit.
  double LargestFlow(Coord width_nm, Coord height_nm) const;
  /// Returns `speed_mm_s`, or the speed at the largest volumetric flow if that is lower.
  static double LimitedByFlow(double speed_mm_s, double section_mm2, double largest_mm3_s);
  /// Returns `speed_mm_s`, or a lower speed for outer walls that would resonate at it.
  double OutsideResonance(Feature feature, double speed_mm_s) const;
  /// Returns `feed_rate` (mm/min), or the feed rate at the largest volumetric flow if `feed_rate`
  /// exceeds it by more than 0.1 %.
  static int32_t WithinFlow(int32_t feed_rate, double section_mm2, double largest_mm3_s);

 private:
  double OnGround(Ground ground, Feature feature, double speed_mm_s) const;
  double InFirstLayers(Feature feature, double speed_mm_s) const;

  const MotionOptions& options_;
  Ground ground_;
  int32_t layer_;
  std::optional<FlowFit> fit_;  ///< filament_adaptive_volumetric_speed
};

/// Returns the speed of travels in mm/s. `first_layer`: true for travels in the first layer, which
/// may have a speed of their own.
double TravelSpeed(const MotionOptions& options, bool first_layer = false);
/// Returns the speed of z moves in mm/s.
double TravelSpeedZ(const MotionOptions& options);

/// Returns the section of the filament, in mm^2.
double FilamentAreaMm2(const MotionOptions& options);

/// Returns a speed in mm/s as a feed rate of the G-code: whole mm/min, at least 1.
int32_t FeedRate(double speed_mm_s);
/// Returns a feed rate (mm/min) as a speed in mm/s.
inline double SpeedOf(int32_t feed_rate) { return feed_rate / 60.0; }

}  // namespace slicefarm::motion
