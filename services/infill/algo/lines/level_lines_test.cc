#include "services/infill/algo/lines/level_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::infill::level_lines_test {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

TEST(LevelLines, AStraightLineGoesOnForEver) {
  const auto lines = LevelLines([](Vec p) { return std::sin(kTurn * (p.v - 0.3)); }, 12);
  ASSERT_EQ(lines.size(), 2u);
  for (const LevelLine& line : lines) {
    EXPECT_FALSE(line.IsClosed());
    EXPECT_EQ(std::abs(line.step_u), 1);
    EXPECT_EQ(line.step_v, 0);
    const double v = line.points[0].v;
    EXPECT_TRUE(std::abs(v - 0.3) < 1e-9 || std::abs(v - 0.8) < 1e-9) << v;
    for (const Vec p : line.points) EXPECT_NEAR(p.v, v, 1e-9);
    EXPECT_NEAR(line.points.back().u - line.points.front().u, line.step_u, 1e-12);
  }
}

TEST(LevelLines, PlusLiesToTheLeft) {
  const auto lines = LevelLines([](Vec p) { return std::sin(kTurn * (p.v - 0.3)); }, 12);
  for (const LevelLine& line : lines) {
    const bool rises = std::abs(line.points[0].v - 0.3) < 0.01;  // minus below, plus above
    EXPECT_EQ(line.step_u, rises ? 1 : -1);
  }
}

TEST(LevelLines, SlantedLinesStepBothWays) {
  const auto lines = LevelLines([](Vec p) { return std::sin(kTurn * (p.v - 2 * p.u - 0.07)); }, 40);
  ASSERT_EQ(lines.size(), 2u);
  for (const LevelLine& line : lines) {
    EXPECT_EQ(std::abs(line.step_u), 1);
    EXPECT_EQ(line.step_v, 2 * line.step_u);
  }
}

TEST(LevelLines, ALoopIsClosedAndLiesOnTheCircle) {
  // cos + cos is near its greatest value around the origin: a loop, across the period's corner.
  const auto f = [](Vec p) { return std::cos(kTurn * p.u) + std::cos(kTurn * p.v) - 1.9; };
  const auto lines = LevelLines(f, 32);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].IsClosed());
  double length = 0;
  for (size_t i = 0; i < lines[0].points.size(); ++i) {
    const Vec a = lines[0].points[i], b = lines[0].points[(i + 1) % lines[0].points.size()];
    EXPECT_NEAR(f(a), 0, 1e-8);
    length += std::hypot(b.u - a.u, b.v - a.v);
  }
  EXPECT_NEAR(length, kTurn * 0.0712, 0.01);
}

// At saddles: lines must not cross, so the sign in the middle of a square decides.
TEST(LevelLines, SaddlesAreTakenByTheirMiddle) {
  for (const double level : {-0.05, 0.05}) {
    const auto f = [level](Vec p) { return std::sin(kTurn * p.u) * std::sin(kTurn * p.v) + level; };
    const auto lines = LevelLines(f, 10);
    EXPECT_EQ(lines.size(), 2u) << level;  // round the two maxima, or the two minima
    for (const LevelLine& line : lines) EXPECT_TRUE(line.IsClosed());
  }
}

TEST(LevelLines, NoneWhereTheSignIsTheSame) {
  EXPECT_TRUE(LevelLines([](Vec) { return 1.0; }, 8).empty());
}

}  // namespace
}  // namespace slicefarm::infill::level_lines_test
