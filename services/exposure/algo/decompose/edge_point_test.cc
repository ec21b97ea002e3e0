#include "services/exposure/algo/decompose/edge_point.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/predicates.h"

namespace slicefarm::exposure::edge_point_test {
namespace {

TEST(PointOnEdge, IsExactOnScaledEdgesAndLeavesFactors) {
  std::mt19937_64 random(7);
  const auto coordinate = [&] { return static_cast<Coord>(random() % 2'000'001) - 1'000'000; };
  for (int i = 0; i < 2000; ++i) {
    constexpr Coord kScale = 1'000'000;
    const Point a{coordinate() * kScale, coordinate() * kScale};
    const Point b{coordinate() * kScale, coordinate() * kScale};
    if (a == b) continue;
    const EdgePoint first = PointOnEdge(a, b, 0.40, 0.42);
    ASSERT_TRUE(first.exact);
    EXPECT_EQ(Orientation(a, b, first.point), 0);
    // The remaining parts of the edge can be divided again and again.
    const EdgePoint second = PointOnEdge(a, first.point, 0.61, 0.63);
    ASSERT_TRUE(second.exact);
    const EdgePoint third = PointOnEdge(second.point, first.point, 0.1, 0.12);
    EXPECT_TRUE(third.exact);
    EXPECT_TRUE(OnSegment(third.point, second.point, first.point));
  }
}

TEST(PointOnEdge, LiesInTheInterval) {
  const Point a{0, 0}, b{1'000'000'000, 500'000'000};
  for (const double low : {0.0, 0.1, 0.33, 0.777}) {
    const EdgePoint place = PointOnEdge(a, b, low, low + 0.01);
    EXPECT_GT(static_cast<double>(place.point.x), low * 1e9);
    EXPECT_LT(static_cast<double>(place.point.x), (low + 0.01) * 1e9);
  }
}

TEST(PointOnEdge, IsToTheLeftWhereIntegersDoNotAllowMore) {
  std::mt19937_64 random(8);
  const auto coordinate = [&] {
    return static_cast<Coord>(random() % 2'000'000'001) - 1'000'000'000;
  };
  for (int i = 0; i < 2000; ++i) {
    const Point a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
    const EdgePoint place = PointOnEdge(a, b, 0.5, 0.500001);
    const int side = Orientation(a, b, place.point);
    EXPECT_EQ(side == 0, place.exact);
    EXPECT_GE(side, 0);
    const double length = Distance(a, b);
    EXPECT_LE(Cross(b - a, place.point - a) / length, 2.0);
  }
}

}  // namespace
}  // namespace slicefarm::exposure::edge_point_test
