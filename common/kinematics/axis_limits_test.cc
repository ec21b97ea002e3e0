#include "common/kinematics/axis_limits.h"

#include <gtest/gtest.h>

namespace slicefarm::axis_limits_test {
namespace {

TEST(LimitedByAxes, TheWorstAxisDecides) {
  EXPECT_DOUBLE_EQ(LimitedByAxes(100, {0.6, 0.8, 0, 0}, {90, 40, 1, 1}), 50);
  EXPECT_DOUBLE_EQ(LimitedByAxes(100, {0.6, -0.8, 0, 0.01}, {30, 80, 1, 0.1}), 10);
}

TEST(LimitedByAxes, LimitsOfZeroAndIdleAxesDoNotCount) {
  EXPECT_DOUBLE_EQ(LimitedByAxes(100, {1, 0, 0, 0}, {0, 1, 1, 1}), 100);
}

}  // namespace
}  // namespace slicefarm::axis_limits_test
