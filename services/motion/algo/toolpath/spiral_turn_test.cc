#include "services/motion/algo/toolpath/spiral_turn.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/measure.h"

namespace slicefarm::motion::spiral_turn_test {
namespace {

using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::Field;

constexpr Coord kWidth = 450'000;

Polygon Ring(double radius_mm, int corners = 64) {
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * 3.14159265358979 * i / corners;
    ring.push_back({FromMm(radius_mm * std::cos(turn)), FromMm(radius_mm * std::sin(turn))});
  }
  return ring;
}

/// Returns the turn in an outline of this radius, from the point on the x axis.
Path TurnIn(double radius_mm) {
  return {.feature = Feature::kExternalPerimeter,
          .closed = true,
          .points = Ring(radius_mm - .225),
          .widths_nm = {kWidth}};
}

double Plastic(const Path& path, const std::vector<TurnPiece>& pieces) {
  double plastic = 0;
  Point from = path.points.front();
  for (const TurnPiece& piece : pieces) {
    plastic += piece.flow * Distance(from, piece.to);
    from = piece.to;
  }
  return plastic;
}

TEST(SpiralTurn, RisesEvenlyWithFullFlow) {
  const Path path = TurnIn(10);
  const auto pieces =
      TurnOf(path, {.start = path.points[0], .from = path.points[0]}, {{Ring(10), {}}});
  ASSERT_EQ(pieces.size(), 64U);
  EXPECT_THAT(pieces, Each(Field(&TurnPiece::flow, 1.0)));
  for (size_t i = 0; i < pieces.size(); ++i)
    EXPECT_THAT(pieces[i].rise, DoubleNear((i + 1) / 64.0, 1e-6));
  EXPECT_EQ(pieces.back().to, path.points.front());
}

TEST(SpiralTurn, FirstAndLastTurnPrintAsMuchAsOneLoop) {
  const Path path = TurnIn(10);
  const auto first = TurnOf(path, {.start = path.points[0]}, {});
  EXPECT_THAT(Plastic(path, first), DoubleNear(PathLength(path) / 2, 1e4));
  const auto last = TurnOf(path, {.start = path.points[0], .from = path.points[0], .last = true},
                           {{Ring(10), {}}});
  EXPECT_THAT(Plastic(path, last), DoubleNear(PathLength(path) * 3 / 2, 1e4));
  EXPECT_THAT(last.back(), Field(&TurnPiece::rise, 1.0));
  EXPECT_LT(last.back().flow, .02);
  const auto only = TurnOf(path, {.start = path.points[0], .last = true}, {});
  EXPECT_THAT(Plastic(path, only), DoubleNear(PathLength(path), 1e4));
}

TEST(SpiralTurn, LeadsOverFromTheTurnBelow) {
  const Path path = TurnIn(10);
  const Point from{FromMm(9.475), 0};  // start of a turn with a radius 0.3 mm smaller
  const auto pieces = TurnOf(path, {.start = path.points[0], .from = from}, {{Ring(9.7), {}}});
  ASSERT_FALSE(pieces.empty());
  // The radius grows as evenly as the height.
  for (const TurnPiece& piece : pieces)
    EXPECT_THAT(ToMm(Norm(piece.to)), DoubleNear(9.475 + .3 * piece.rise, .002));
}

TEST(SpiralTurn, DoesNotLeadOverFromFarAwayNorWhereItMustNot) {
  const Path path = TurnIn(10);
  const struct {
    const char* name;
    double radius_below_mm;
    bool blends;
  } cases[] = {{"far", 6, true}, {"fuzzy", 9.7, false}};
  for (const auto& [name, radius_mm, blends] : cases) {
    const auto pieces =
        TurnOf(path, {.start = path.points[0], .from = path.points[0], .blends = blends},
               {{Ring(radius_mm), {}}});
    for (size_t i = 0; i + 1 < pieces.size(); ++i)
      EXPECT_EQ(pieces[i].to, path.points[i + 1]) << name;
  }
}

TEST(TurnOf, BeginsAndEndsWithTheFlowOfTheSettings) {
  const Path path = TurnIn(10);
  const SpiralMotion options = {.start_flow = 0.5, .end_flow = 0.25};
  const auto first = TurnOf(path, {.start = path.points[0]}, {}, options);
  EXPECT_NEAR(first.front().flow, 0.5, 0.02);
  EXPECT_NEAR(first.back().flow, 1, 0.02);
  const auto last =
      TurnOf(path, {.start = path.points[0], .from = path.points[0], .last = true}, {}, options);
  EXPECT_EQ(last.front().flow, 1);
  EXPECT_NEAR(last.back().flow, 0.25, 0.02);
}

TEST(TurnOf, ReachesAsFarAsTheSettingsSay) {
  const Path path = TurnIn(10);
  const Point from{-9'700'000, 0};
  const SpiralTurn turn = {.start = path.points[0], .from = from};
  const auto moved = [&](Coord reach_nm) {
    const auto pieces = TurnOf(path, turn, {{Ring(9.7), {}}}, {.reach_nm = reach_nm});
    return pieces.front().to != path.points[1];
  };
  EXPECT_TRUE(moved(0));
  EXPECT_TRUE(moved(1'000'000));
  EXPECT_FALSE(moved(100'000));
}

}  // namespace
}  // namespace slicefarm::motion::spiral_turn_test
