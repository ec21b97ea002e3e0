#include "common/geometry/boolean/fast_boolean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "common/geometry/boolean/clipper_oracle_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::fast_boolean_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }
double Mm2(const MultiPolygon& polygons) { return Area(polygons) / 1e12; }

TEST(FastBoolean, OverlappingSquares) {
  const MultiPolygon a = P("(0 0, 10 0, 10 10, 0 10)"), b = P("(5 5, 15 5, 15 15, 5 15)");
  EXPECT_EQ(*TryBoolean(a, b, Operation::kIntersection), P("(5 5, 10 5, 10 10, 5 10)"));
  EXPECT_EQ(Mm2(*TryBoolean(a, b, Operation::kUnion)), 175);
  EXPECT_EQ(Mm2(*TryBoolean(a, b, Operation::kDifference)), 75);
  EXPECT_EQ(Mm2(*TryBoolean(b, a, Operation::kDifference)), 75);
}

TEST(FastBoolean, OneInTheOtherAndApart) {
  const MultiPolygon big = P("(0 0, 10 0, 10 10, 0 10)"), small = P("(3 3, 6 3, 6 6, 3 6)"),
                     far = P("(20 0, 21 0, 21 1)");
  const auto frame = TryBoolean(big, small, Operation::kDifference);
  ASSERT_TRUE(frame.has_value());
  ASSERT_EQ(frame->size(), 1u);
  EXPECT_EQ(frame->front().holes.size(), 1u);
  EXPECT_TRUE(TryBoolean(small, big, Operation::kDifference)->empty());
  EXPECT_EQ(*TryBoolean(big, small, Operation::kIntersection), small);
  EXPECT_EQ(*TryBoolean(big, small, Operation::kUnion), big);
  EXPECT_EQ(TryBoolean(big, far, Operation::kUnion)->size(), 2u);
  EXPECT_TRUE(TryBoolean(big, far, Operation::kIntersection)->empty());
  EXPECT_EQ(*TryBoolean(big, far, Operation::kDifference), big);
}

TEST(FastBoolean, TouchingIsDoubtful) {
  const MultiPolygon a = P("(0 0, 10 0, 10 10, 0 10)");
  for (const char* b :
       {"(0 0, 10 0, 10 10, 0 10)", "(10 2, 12 2, 12 4, 10 4)", "(10 10, 12 10, 12 12)"})
    EXPECT_FALSE(TryBoolean(a, P(b), Operation::kUnion).has_value()) << b;
}

/// Returns a wavy ring around a point, with a hole of the same kind.
PolygonWithHoles Wavy(std::mt19937& random, Point middle) {
  std::uniform_real_distribution<double> unit(0, 1);
  PolygonWithHoles island;
  const double radius = 4 + 4 * unit(random);
  const int waves = 2 + static_cast<int>(6 * unit(random)),
            points = 24 + static_cast<int>(60 * unit(random));
  const double phase = 6 * unit(random), depth = 0.3 * unit(random);
  Polygon hole;
  for (int i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * i / points;
    const double r = radius * (1 + depth * std::sin(waves * t + phase));
    island.outer.push_back(
        {middle.x + FromMm(r * std::cos(t)), middle.y + FromMm(r * std::sin(t))});
    hole.push_back(
        {middle.x + FromMm(r / 2 * std::cos(-t)), middle.y + FromMm(r / 3 * std::sin(-t))});
  }
  island.holes.push_back(hole);
  return island;
}

// For any two regions, the result equals Clipper's result, except for the rounding of crossings.
TEST(FastBoolean, GivesTheSetsThatClipperGives) {
  std::mt19937 random(7);
  int tried = 0;
  for (int i = 0; i < 300; ++i) {
    const MultiPolygon a = {Wavy(random, {0, 0})};
    const MultiPolygon b = {Wavy(random, {FromMm(i % 17), FromMm(i % 5)})};
    for (const Operation op :
         {Operation::kUnion, Operation::kIntersection, Operation::kDifference}) {
      const auto got = TryBoolean(a, b, op);
      if (!got) continue;
      ++tried;
      const MultiPolygon want = ClipperBoolean(a, b, op);
      EXPECT_EQ(got->size(), want.size()) << i;
      EXPECT_LT(Apart(*got, want), 1e-6) << i;  // 1 nm along a metre
    }
  }
  EXPECT_GT(tried, 870);
}

}  // namespace
}  // namespace slicefarm::fast_boolean_test
