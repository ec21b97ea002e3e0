#include "common/kinematics/reprap_junction.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicefarm::reprap_junction_test {
namespace {

KinematicMove Towards(double x, double y, double e = 0) { return {10, {x, y, 0, e}, 100, 3000}; }

double V(const KinematicMove& before, const KinematicMove& move) {
  return std::sqrt(RepRapJunctionV2(before, move, MachineLimits{}));  // jerk: 8, 8, 0.4, 2.5
}

TEST(RepRapJunction, NoAxisJerksBeyondItsLimit) {
  EXPECT_DOUBLE_EQ(V(Towards(1, 0), Towards(1, 0)), 100);
  EXPECT_DOUBLE_EQ(V(Towards(1, 0), Towards(0, 1)), 8);
  EXPECT_DOUBLE_EQ(V(Towards(1, 0), Towards(-1, 0)), 4);
  EXPECT_DOUBLE_EQ(V(Towards(1, 0), Towards(0.8, 0.6)), 8 / 0.6);
  EXPECT_DOUBLE_EQ(V(Towards(1, 0, 0.05), Towards(1, 0, 0.1)), 50);
}

TEST(RepRapJunction, StopsBetweenMovesThatAreNotAlike) {
  const KinematicMove up{1, {0, 0, 1, 0}, 10, 3000}, retract{1, {0, 0, 0, -1}, 30, 3000};
  EXPECT_EQ(V(Towards(1, 0), Towards(1, 0, 0.03)), 0);
  EXPECT_EQ(V(Towards(1, 0), up), 0);
  EXPECT_EQ(V(up, retract), 0);
  EXPECT_EQ(V(Towards(1, 0), Towards(1, 0, -0.1)), 0) << "a wipe while retracting";
}

TEST(LimitedByRepRap, WhatIsAskedForCountsInThePlane) {
  const MachineLimits limits;
  EXPECT_EQ(LimitedByRepRap({1, {0, 0, 0, -1}, 35, 10}, limits).acceleration_mm_s2, 3000);
  EXPECT_EQ(LimitedByRepRap({1, {0, 0, 1, 0}, 35, 10}, limits).acceleration_mm_s2, 500);
  EXPECT_EQ(LimitedByRepRap({1, {1, 0, 0, 0}, 35, 10}, limits).acceleration_mm_s2, 10);
}

}  // namespace
}  // namespace slicefarm::reprap_junction_test
