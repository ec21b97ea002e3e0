#include "common/geometry/rings/simplify.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::simplify_test {
namespace {

Polygon Circle(int points, double radius_mm) {
  Polygon ring;
  for (int i = 0; i < points; ++i) {
    const double a = 2 * std::numbers::pi * i / points;
    ring.push_back({FromMm(radius_mm * std::cos(a)), FromMm(radius_mm * std::sin(a))});
  }
  return ring;
}

double Farthest(const Polygon& from, const Polygon& to) {
  double farthest = 0;
  for (const Point p : from) {
    double nearest = 1e18;
    for (size_t i = 0; i < to.size(); ++i)
      nearest = std::min(nearest, DistanceToSegment(p, to[i], to[(i + 1) % to.size()]));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

TEST(SimplifyLine, DropsWhatLiesOnTheLine) {
  EXPECT_EQ(ToText(SimplifyLine(MakeLineOrDie("(0 0, 1 0, 2 0, 5 0, 5 3)"), 1)), "(0 0, 5 0, 5 3)");
  EXPECT_EQ(ToText(SimplifyLine(MakeLineOrDie("(0 0, 1 0.01, 2 0)"), FromMm(0.01))), "(0 0, 2 0)");
  EXPECT_EQ(SimplifyLine(MakeLineOrDie("(0 0, 1 0.011, 2 0)"), FromMm(0.01)).size(), 3u);
}

TEST(SimplifyRing, StaysWithinTheTolerance) {
  const Polygon circle = Circle(1000, 20);
  for (const double tolerance : {0.001, 0.01, 0.1}) {
    const Polygon simple = SimplifyRing(circle, FromMm(tolerance));
    EXPECT_LT(simple.size(), circle.size() / 2) << tolerance;
    EXPECT_LE(Farthest(circle, simple), FromMm(tolerance) + 1) << tolerance;
  }
}

TEST(SimplifyRing, DoesNotDependOnTheStart) {
  Polygon circle = Circle(360, 20);
  const Polygon simple = SimplifyRing(circle, FromMm(0.01));
  for (int i = 0; i < 360; i += 41) {
    std::rotate(circle.begin(), circle.begin() + 41, circle.end());
    EXPECT_EQ(SimplifyRing(circle, FromMm(0.01)), simple);
  }
}

TEST(SimplifyRing, WhatIsThinnerThanTheToleranceVanishes) {
  EXPECT_TRUE(SimplifyRing(MakeLineOrDie("(0 0, 9 0, 9 0.004, 0 0.004)"), FromMm(0.005)).empty());
  EXPECT_TRUE(SimplifyRing(MakeLineOrDie("(0 0, 9 0)"), 1).empty());
  EXPECT_TRUE(SimplifyRing({{7, 7}, {7, 7}, {7, 7}}, 1).empty());
}

TEST(Simplify, HolesGoWithTheirIsland) {
  const MultiPolygon simple =
      Simplify(MakePolygonsOrDie(
                   "(0 0, 9 0, 9 9, 0 9) (4 4, 4.001 4, 4.001 4.001) ; (20 0, 20.001 0, 20 0.001)"),
               FromMm(0.01));
  ASSERT_EQ(simple.size(), 1u);
  EXPECT_TRUE(simple[0].holes.empty());
}

/// Runs `work` with such a small stack that deep recursion fails.
void OnASmallStack(void* (*work)(void*), void* argument) {
  pthread_attr_t attributes;
  pthread_t thread;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, 256 << 10), 0);
  ASSERT_EQ(pthread_create(&thread, &attributes, work, argument), 0);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
}

// A zigzag of decreasing size is split at its first point each time, so recursion would be as deep
// as the zigzag is long.
TEST(SimplifyLine, DoesNotRecurse) {
  constexpr int kPoints = 5'000;
  Polyline line;
  for (int i = 0; i < kPoints; ++i)
    line.push_back({i * 1'000, (i % 2 == 0 ? 10'000 : -10'000) * Coord{kPoints - i}});
  const auto simplify = [](void* lines) -> void* {
    *static_cast<Polyline*>(lines) = SimplifyLine(*static_cast<Polyline*>(lines), 2'000);
    return nullptr;
  };
  Polyline simple = line;
  OnASmallStack(simplify, &simple);
  EXPECT_EQ(simple, line);
}

}  // namespace
}  // namespace slicefarm::simplify_test
