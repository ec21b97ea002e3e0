#include "common/kinematics/jerk_ramp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace slicefarm::jerk_ramp_test {
namespace {

constexpr RampLimits kLimits{1000, 1e5};

struct RampCase {
  std::string_view name;
  double from, to;
  double time_s, length_mm;
};

class RampTest : public testing::TestWithParam<RampCase> {};

TEST_P(RampTest, HasItsClosedForm) {
  const RampCase& c = GetParam();
  EXPECT_NEAR(RampTime(c.to - c.from, kLimits), c.time_s, 1e-7);
  EXPECT_NEAR(RampLength(c.from, c.to, kLimits), c.length_mm, 1e-7);
  EXPECT_NEAR(RampLength(c.to, c.from, kLimits), c.length_mm, 1e-7);
  EXPECT_NEAR(SpeedAfter(c.from, RampLength(c.from, c.to, kLimits), kLimits), c.to, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(
    Motion, RampTest,
    testing::Values(RampCase{"FromRest", 0, 100, 0.11, 5.5},
                    RampCase{"FromSpeed", 20, 100, 0.09, 5.4},
                    RampCase{"ShortFromRest", 0, 5, 0.0141421356, 0.0353553391},
                    RampCase{"ShortFromSpeed", 50, 52, 0.0089442719, 0.4561578669},
                    RampCase{"JustToTheLimit", 0, 10, 0.02, 0.1}),
    [](const auto& info) { return std::string(info.param.name); });

struct MoveCase {
  std::string_view name;
  double length_mm;
  double entry, exit;
  double peak, time_s;
  size_t phases;
};

class JerkProfileTest : public testing::TestWithParam<MoveCase> {};

TEST_P(JerkProfileTest, HasItsClosedForm) {
  const MoveCase& c = GetParam();
  const JerkProfile profile(c.length_mm, c.entry, 100, c.exit, kLimits);
  EXPECT_NEAR(profile.peak_mm_s(), c.peak, 1e-7);
  EXPECT_NEAR(profile.time_s(), c.time_s, 1e-7);
  EXPECT_EQ(profile.phases().size(), c.phases);
}

INSTANTIATE_TEST_SUITE_P(Motion, JerkProfileTest,
                         testing::Values(MoveCase{"Long", 40, 0, 0, 100, 0.51, 7},
                                         MoveCase{"LittleCruise", 12, 0, 0, 100, 0.23, 7},
                                         MoveCase{"NoCruise", 11, 0, 0, 100, 0.22, 6},
                                         MoveCase{"LowerPeak", 4, 0, 0, 58.4428877, 0.1368858, 6},
                                         MoveCase{"BelowTheAccelerationsLimit", 0.05, 0, 0,
                                                  3.9685026, 0.0251984, 4},
                                         MoveCase{"EvenSpeed", 10, 100, 100, 100, 0.1, 1},
                                         MoveCase{"SpeedsUpOnly", 5.4, 20, 100, 100, 0.09, 3},
                                         MoveCase{"SlowsDownOnly", 5.4, 100, 20, 100, 0.09, 3}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(JerkProfile, ShortMovesPeakBelowTheAccelerationsLimit) {
  const JerkProfile profile(0.05, 0, 100, 0, kLimits);
  EXPECT_NEAR(profile.phases()[1].acceleration_mm_s2, 629.9605, 1e-4);
}

// 80 mm/s need 3.6 mm to stop; within 1 mm only a lower speed can be stopped.
TEST(SpeedAfter, IsWhatLookAheadHasToLowerTo) {
  EXPECT_NEAR(RampLength(80, 0, kLimits), 3.6, 1e-9);
  const double entry = SpeedAfter(0, 1, kLimits);
  EXPECT_LT(entry, 80);
  EXPECT_NEAR(RampLength(entry, 0, kLimits), 1, 1e-12);
  EXPECT_EQ(SpeedAfter(30, 0, kLimits), 30);
}

// For any end speeds, no limit is exceeded, no value jumps, and the length is exact.
TEST(JerkProfile, KeepsItsLimits) {
  std::mt19937 random(7);
  const auto in = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 100'001) / 100'000;
  };
  for (int i = 0; i < 20'000; ++i) {
    const RampLimits limits{in(100, 10'000), in(1e3, 1e6)};
    const double top = in(10, 300), entry = in(0, top);
    const double length = std::pow(10, in(-3, 2));
    const double exit = std::min(in(0, top), SpeedAfter(entry, length, limits));
    if (RampLength(entry, exit, limits) > length) continue;
    const JerkProfile profile(length, entry, top, exit, limits);
    ASSERT_LE(profile.peak_mm_s(), top);
    double speed = entry, acceleration = 0, path = 0;
    for (const JerkPhase& phase : profile.phases()) {
      ASSERT_NEAR(phase.speed_mm_s, speed, 1e-6 * top);
      ASSERT_NEAR(phase.acceleration_mm_s2, acceleration, 1e-6 * limits.acceleration_mm_s2);
      ASSERT_LE(std::abs(phase.jerk_mm_s3), limits.jerk_mm_s3 * (1 + 1e-12));
      ASSERT_LE(std::abs(phase.acceleration_mm_s2), limits.acceleration_mm_s2 * (1 + 1e-12));
      speed = phase.SpeedAt(phase.time_s);
      acceleration += phase.jerk_mm_s3 * phase.time_s;
      path += phase.LengthAt(phase.time_s);
    }
    ASSERT_NEAR(speed, exit, 1e-6 * top);
    ASSERT_NEAR(path, length, 1e-6 * (length + 1));
  }
}

TEST(ProfileWalk, PassesPlacesWhenTheProfileDoes) {
  const JerkProfile profile(12, 20, 100, 40, kLimits);
  ProfileWalk walk(profile);
  double before_s = 0, before_mm = 0;
  for (double path = 0.1; path < 12; path += 0.1) {
    const auto [time_s, speed] = walk.At(path);
    ASSERT_GT(time_s, before_s);
    // The speed hardly changes over 0.1 mm.
    ASSERT_NEAR((path - before_mm) / (time_s - before_s), speed, 4);
    before_s = time_s;
    before_mm = path;
  }
  EXPECT_NEAR(walk.At(12).time_s, profile.time_s(), 1e-9);
  EXPECT_NEAR(walk.At(12).speed_mm_s, 40, 1e-4);
}

}  // namespace
}  // namespace slicefarm::jerk_ramp_test
