#include "services/motion/algo/toolpath/travel_time.h"

#include "services/motion/algo/firmware/firmware.h"
#include "services/motion/algo/kinematics/trapezoid.h"
#include "services/motion/algo/toolpath/accelerations.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

double FromRestToRest(const KinematicMove& asked, const MotionOptions& options) {
  const auto planner = FirmwareOf(options.flavor).MakePlanner(options.limits);
  const KinematicMove move = planner->Limited(asked);
  return RestToRest(move.length_mm, move.speed_mm_s, move.acceleration_mm_s2);
}

double TravelAcceleration(const MotionOptions& options, int32_t layer_index) {
  const Accelerations accelerations = AccelerationsFor(options, layer_index);
  return accelerations.Travel(accelerations.Print(Feature::kPerimeter));
}

}  // namespace

double TravelTime(Point from, Point to, const MotionOptions& options, int32_t layer_index) {
  const double length = ToMm(Distance(from, to));
  if (length == 0) return 0;
  const double x = ToMm(static_cast<double>(to.x - from.x)) / length;
  const double y = ToMm(static_cast<double>(to.y - from.y)) / length;
  return FromRestToRest({length, {x, y, 0, 0}, TravelSpeed(options),
                         TravelAcceleration(options, layer_index)},
                        options);
}

double LiftTime(double height_mm, const MotionOptions& options, int32_t layer_index) {
  if (height_mm == 0) return 0;
  return FromRestToRest({height_mm, {0, 0, 1, 0}, TravelSpeedZ(options),
                         TravelAcceleration(options, layer_index)},
                        options);
}

}  // namespace slicefarm::motion
