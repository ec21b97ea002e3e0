#include "services/infill/algo/lines/level_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::infill::level_lines_test {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

TEST(LevelLines, AStraightLineGoesOnForEver) {
  const auto lines = LevelLines([](Vector2 p) { return std::sin(kTurn * (p.y() - 0.3)); }, 12);
  ASSERT_EQ(lines.size(), 2u);
  for (const LevelLine& line : lines) {
    EXPECT_FALSE(line.IsClosed());
    EXPECT_EQ(std::abs(line.step_u), 1);
    EXPECT_EQ(line.step_v, 0);
    const double v = line.points[0].y();
    EXPECT_TRUE(std::abs(v - 0.3) < 1e-9 || std::abs(v - 0.8) < 1e-9) << v;
    for (const Vector2& p : line.points) EXPECT_NEAR(p.y(), v, 1e-9);
    EXPECT_NEAR(line.points.back().x() - line.points.front().x(), line.step_u, 1e-12);
  }
}

TEST(LevelLines, PlusLiesToTheLeft) {
  const auto lines = LevelLines([](Vector2 p) { return std::sin(kTurn * (p.y() - 0.3)); }, 12);
  ASSERT_FALSE(lines.empty());
  for (const LevelLine& line : lines) {
    const bool rises = std::abs(line.points[0].y() - 0.3) < 0.01;  // minus below, plus above
    EXPECT_EQ(line.step_u, rises ? 1 : -1);
  }
}

TEST(LevelLines, SlantedLinesStepBothWays) {
  const auto lines =
      LevelLines([](Vector2 p) { return std::sin(kTurn * (p.y() - 2 * p.x() - 0.07)); }, 40);
  ASSERT_EQ(lines.size(), 2u);
  for (const LevelLine& line : lines) {
    EXPECT_EQ(std::abs(line.step_u), 1);
    EXPECT_EQ(line.step_v, 2 * line.step_u);
  }
}

TEST(LevelLines, ALoopIsClosedAndLiesOnTheCircle) {
  // cos + cos is near its maximum around the origin: the line is a loop across the period's corner.
  const auto f = [](Vector2 p) { return std::cos(kTurn * p.x()) + std::cos(kTurn * p.y()) - 1.9; };
  const auto lines = LevelLines(f, 32);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].IsClosed());
  double length = 0;
  for (size_t i = 0; i < lines[0].points.size(); ++i) {
    const Vector2 a = lines[0].points[i], b = lines[0].points[(i + 1) % lines[0].points.size()];
    EXPECT_NEAR(f(a), 0, 1e-8);
    length += std::hypot(b.x() - a.x(), b.y() - a.y());
  }
  EXPECT_NEAR(length, kTurn * 0.0712, 0.01);
}

// At saddles lines must not cross, so that the sign in the middle of a square decides.
TEST(LevelLines, SaddlesAreTakenByTheirMiddle) {
  for (const double level : {-0.05, 0.05}) {
    const auto f = [level](Vector2 p) {
      return std::sin(kTurn * p.x()) * std::sin(kTurn * p.y()) + level;
    };
    const auto lines = LevelLines(f, 10);
    EXPECT_EQ(lines.size(), 2u) << level;  // around the two maxima or minima
    for (const LevelLine& line : lines) EXPECT_TRUE(line.IsClosed());
  }
}

TEST(LevelLines, NoneWhereTheSignIsTheSame) {
  EXPECT_TRUE(LevelLines([](Vector2) { return 1.0; }, 8).empty());
}

}  // namespace
}  // namespace slicefarm::infill::level_lines_test
