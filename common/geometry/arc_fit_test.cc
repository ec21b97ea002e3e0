#include "common/geometry/arc_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace slicefarm::arc_fit_test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Returns points of a circle around (50, 50) mm, over an angle of `turn` radians.
std::vector<PointUm> Circle(double radius_um, double turn, int segments) {
  std::vector<PointUm> points;
  for (int i = 0; i <= segments; ++i) {
    const double angle = turn * i / segments;
    points.push_back({static_cast<int32_t>(std::lround(50'000 + radius_um * std::cos(angle))),
                      static_cast<int32_t>(std::lround(50'000 + radius_um * std::sin(angle)))});
  }
  return points;
}

double DistanceToArc(const CurvePiece& arc, PointUm from, double x, double y) {
  const double radius = std::hypot(from.x - arc.centre.x, from.y - arc.centre.y);
  return std::abs(std::hypot(x - arc.centre.x, y - arc.centre.y) - radius);
}

TEST(FitArcs, ACircleIsTwoArcs) {
  const auto points = Circle(10'000, 2 * kPi, 100);
  const auto pieces = FitArcs(points);
  ASSERT_LE(pieces.size(), 3);
  EXPECT_TRUE(pieces[0].is_arc);
  EXPECT_FALSE(pieces[0].clockwise);
  EXPECT_NEAR(pieces[0].centre.x, 50'000, 3);
  EXPECT_EQ(pieces.back().last, 100);
}

TEST(FitArcs, KnowsTheWayRound) { EXPECT_TRUE(FitArcs(Circle(5'000, -kPi, 50))[0].clockwise); }

TEST(FitArcs, LinesAndCornersStay) {
  const std::vector<PointUm> square = {{0, 0}, {20'000, 0}, {20'000, 20'000}, {0, 20'000}, {0, 0}};
  const std::vector<PointUm> line = {{0, 0}, {1'000, 0}, {2'000, 0}, {3'000, 0}, {4'000, 0}};
  for (const auto& points : {square, line}) {
    const auto pieces = FitArcs(points);
    ASSERT_FALSE(pieces.empty());
    for (const CurvePiece& piece : pieces) EXPECT_FALSE(piece.is_arc);
  }
  EXPECT_TRUE(FitArcs(std::vector<PointUm>{{0, 0}}).empty());
}

TEST(FitArcs, CoarseCirclesStayPolygons) {
  const auto pieces = FitArcs(Circle(20'000, 2 * kPi, 12));
  ASSERT_FALSE(pieces.empty());
  for (const CurvePiece& piece : pieces) EXPECT_FALSE(piece.is_arc);
}

// Joins arcs and lines, with noise. Every point and the middle of every segment must be within the
// tolerance of its arc, and the arc must not deviate elsewhere.
TEST(FitArcs, StaysWithinTheTolerance) {
  std::mt19937 random(3);
  int arcs = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const double radius = 500 + random() % 40'000;
    auto points =
        Circle(radius, (random() % 2 ? 1 : -1) * (0.3 + random() % 5), 20 + random() % 200);
    const int noise = static_cast<int>(random() % 25);
    for (PointUm& point : points) {
      if (noise > 0) point.x += static_cast<int32_t>(random() % noise);
    }
    points.erase(std::unique(points.begin(), points.end()), points.end());
    size_t at = 0;
    for (const CurvePiece& piece : FitArcs(points)) {
      ASSERT_GT(piece.last, at);
      if (piece.is_arc) {
        ++arcs;
        EXPECT_GE(piece.last - at, 3);
        for (size_t i = at; i < piece.last; ++i) {
          const PointUm a = points[i], b = points[i + 1];
          ASSERT_LE(DistanceToArc(piece, points[at], b.x, b.y), kArcToleranceUm);
          ASSERT_LE(DistanceToArc(piece, points[at], (a.x + b.x) / 2.0, (a.y + b.y) / 2.0),
                    kArcToleranceUm);
        }
        ASSERT_LE(DistanceToArc(piece, points[at], points[piece.last].x, points[piece.last].y), 2);
      }
      at = piece.last;
    }
    ASSERT_EQ(at, points.size() - 1);
  }
  EXPECT_GT(arcs, 300);
}

/// A circle of 10 mm in 48 segments deviates from its chords by 21 um.
TEST(FitArcs, KeepsToTheToleranceThatItIsTold) {
  const std::vector<PointUm> coarse = Circle(10'000, kPi, 24), fine = Circle(10'000, kPi, 96);
  EXPECT_TRUE(FitArcs(coarse)[0].is_arc);
  EXPECT_FALSE(FitArcs(coarse, 5)[0].is_arc);
  EXPECT_TRUE(FitArcs(fine, 5)[0].is_arc);
}

}  // namespace
}  // namespace slicefarm::arc_fit_test
