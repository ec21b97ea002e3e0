#pragma once

#include "common/model/path.h"
#include "services/motion/algo/toolpath/toolpath.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Walls of no more than this length count as small: loops of a radius of 6.5 mm.
inline constexpr double kSmallLoopMm = 40.840704496667314;

/// How fast a path may be printed, in mm/s, by its region's settings: the feature's speed, that of
/// small walls, that of the first layer on the bed or on a raft; never above max_print_speed where
/// the settings leave it open, nor above max_volumetric_speed. `section_mm2`: of its bead, flow
/// included.
class PrintSpeeds {
 public:
  PrintSpeeds(const MotionOptions& options, Ground ground) : options_(options), ground_(ground) {}

  /// Without regard to the volume. `length_mm`: of a wall, that of the contour that it is a piece of
  /// (contour_length.h). REQUIRES: the path's settings have a row.
  double Of(const Path& path, double length_mm) const;
  /// What is left of it where only `rest` of a wall's width has something below.
  double OverAir(const Path& path, double speed_mm_s, uint8_t rest) const;
  /// `speed_mm_s`, lowered until no more than the greatest volume flows.
  double LimitedByFlow(double speed_mm_s, double section_mm2) const;
  /// The same for feed rates, in mm/min, but for what makes less than 0.1 % of the volume.
  int32_t WithinFlow(int32_t feed_rate, double section_mm2) const;

 private:
  double OnGround(Feature feature, double speed_mm_s) const;

  const MotionOptions& options_;
  Ground ground_;
};

/// Speed of travels, on the first layer if `first_layer`, and of z moves, in mm/s.
double TravelSpeed(const MotionOptions& options, bool first_layer = false);
double TravelSpeedZ(const MotionOptions& options);

/// Feed rates stand in the G-code as whole mm/min, at least 1.
int32_t FeedRate(double speed_mm_s);
inline double SpeedOf(int32_t feed_rate) { return feed_rate / 60.0; }

}  // namespace slicefarm::motion
