#include "services/motion/algo/toolpath/travel_time.h"

#include <gtest/gtest.h>

#include "services/motion/algo/kinematics/trapezoid.h"

namespace slicefarm::motion {
namespace {

MotionOptions Options() {
  MotionOptions options;
  options.travel_speed_mm_s = 100;
  options.travel_speed_z_mm_s = 8;
  options.limits.max_acceleration_travel_mm_s2 = 3000;
  options.limits.max_acceleration_mm_s2 = {3000, 3000, 500, 3000};
  return options;
}

TEST(TravelTime, FromRestToRest) {
  const Point to{FromMm(60), FromMm(80)};
  EXPECT_DOUBLE_EQ(TravelTime({}, to, Options(), 1), RestToRest(100, 100, 3000));
  EXPECT_EQ(TravelTime(to, to, Options(), 1), 0);
}

TEST(LiftTime, ByTheLimitsOfZ) {
  EXPECT_DOUBLE_EQ(LiftTime(0.4, Options(), 1), RestToRest(0.4, 8, 500));
  EXPECT_EQ(LiftTime(0, Options(), 1), 0);
}

}  // namespace
}  // namespace slicefarm::motion
