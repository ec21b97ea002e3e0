#include "services/milling/algo/motion/mill_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::mill_clock_test {
namespace {

MillMove LineTo(double x, double y, double z, double feed_mm_min) {
  return {.kind = MoveKind::kLine, .to_mm = {x, y, z}, .feed_mm_min = feed_mm_min};
}

MillingOptions Machine() {
  MillingOptions options = OptionsFor("cyl:2");
  options.machining.max_acceleration_mm_s2 = {500, 500, 100};
  options.machining.jerk_mm_s3 = 20'000;
  options.machining.rapid_mm_min = 3000;
  return options;
}

/// The time from standstill to standstill is the length divided by the speed, plus the time of one
/// ramp (jerk_ramp.h).
TEST(TimesOf, AMoveSpeedsUpAndSlowsDown) {
  const MillMove moves[] = {LineTo(0, 0, 0, 600), LineTo(10, 0, 0, 600)};
  const auto times = TimesOf(moves, Machine());
  EXPECT_EQ(times[0].seconds, 0);
  EXPECT_NEAR(times[1].seconds, 1 + 2 * std::sqrt(10 / 20'000.0), 1e-9);
  EXPECT_NEAR(times[1].fastest_mm_s, 10, 1e-9);
}

/// Z is the slowest axis. A feed faster than the machine is limited to the machine's speed.
TEST(TimesOf, FollowTheAxesAndTheFastestSpeed) {
  const MillMove up[] = {LineTo(0, 0, 0, 600), {.to_mm = {0, 0, 100}}};
  EXPECT_NEAR(TimesOf(up, Machine())[1].seconds, 2 + 50.0 / 100 + 100.0 / 20'000, 1e-9);
  const MillMove fast[] = {LineTo(0, 0, 0, 600), LineTo(100, 0, 0, 1e6)};
  EXPECT_NEAR(TimesOf(fast, Machine())[1].seconds, 2 + 50.0 / 500 + 500.0 / 20'000, 1e-9);
}

TEST(TimesOf, RestBetweenRapidMovesAndCuts) {
  const MillMove moves[] = {{.to_mm = {0, 0, 0}}, {.to_mm = {10, 0, 0}}, LineTo(20, 0, 0, 600)};
  const auto times = TimesOf(moves, Machine());
  EXPECT_NEAR(times[2].seconds, 1 + 2 * std::sqrt(10 / 20'000.0), 1e-9);
}

/// sqrt(a r) and cbrt(j r^2) limit the speed on a circle; here the second one does.
TEST(TimesOf, CurvesAreAsSlowAsTheyMustBe) {
  MillingOptions options = Machine();
  options.machining.jerk_mm_s3 = 1000;
  const MillMove moves[] = {LineTo(1, 0, 0, 6000),
                            {.kind = MoveKind::kCounterClockwise,
                             .to_mm = {1, 0, 0},
                             .centre_mm = {0, 0},
                             .feed_mm_min = 2400}};
  const auto times = TimesOf(moves, options);
  EXPECT_NEAR(times[1].fastest_mm_s, 10, 0.1);
  EXPECT_GT(times[1].seconds, 2 * std::numbers::pi / 10);
}

/// Feeds that the machine reaches stay. Other feeds go down to the next twentieth, which takes no
/// extra time.
TEST(LowerFeeds, GoDownOnlyWhereTheMachineCannotFollow) {
  std::vector<MillMove> moves = {LineTo(0, 0, 0, 2400), LineTo(100, 0, 0, 2400),
                                 LineTo(100, 0.5, 0, 2400), LineTo(0, 0.5, 0, 2400)};
  const auto before = TimesOf(moves, Machine());
  LowerFeeds(Machine(), moves);
  EXPECT_EQ(moves[1].feed_mm_min, 2400);
  EXPECT_EQ(moves[3].feed_mm_min, 2400);
  EXPECT_LT(moves[2].feed_mm_min, 1200);
  EXPECT_GE(moves[2].feed_mm_min, 60 * before[2].fastest_mm_s);
  EXPECT_NEAR(std::remainder(moves[2].feed_mm_min, 120), 0, 1e-9);
  EXPECT_NEAR(TimesOf(moves, Machine())[2].seconds, before[2].seconds, 1e-9);
}

TEST(LowerFeeds, AProgramHasThemOnRequest) {
  MillingOptions options = OptionsFor("cyl:2");
  options.machining.feed_mm_min = 3000;
  const MillProgram asked = ProgramOf(JobOf(PocketPart().Mesh(), options));
  options.machining.corner_feeds = true;
  const MillProgram lowered = ProgramOf(JobOf(PocketPart().Mesh(), options));
  ASSERT_EQ(asked.moves.size(), lowered.moves.size());
  size_t slower = 0;
  for (size_t i = 0; i < asked.moves.size(); ++i) {
    EXPECT_EQ(asked.moves[i].to_mm, lowered.moves[i].to_mm);
    EXPECT_LE(lowered.moves[i].feed_mm_min, asked.moves[i].feed_mm_min);
    slower += lowered.moves[i].feed_mm_min < asked.moves[i].feed_mm_min ? 1 : 0;
  }
  EXPECT_GT(slower, 0u);
}

TEST(TimesOf, StopWhenCancelled) {
  const MillMove moves[] = {{.to_mm = {0, 0, 0}}, LineTo(10, 0, 0, 600), {.to_mm = {0, 0, 0}}};
  const auto times = TimesOf(moves, Machine(), CancelToken([] { return true; }));
  EXPECT_EQ(times[2].seconds, 0);
}

}  // namespace
}  // namespace slicefarm::milling::mill_clock_test
