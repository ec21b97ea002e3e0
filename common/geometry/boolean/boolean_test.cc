#include "common/geometry/boolean/boolean.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::boolean_test {
namespace {

double AreaMm2(const MultiPolygon& polygons) { return Area(polygons) / 1e12; }
MultiPolygon Square(double x, double y, double size) {
  const Coord x0 = FromMm(x), y0 = FromMm(y), s = FromMm(size);
  return {{{{x0, y0}, {x0 + s, y0}, {x0 + s, y0 + s}, {x0, y0 + s}}, {}}};
}

TEST(Boolean, OverlappingSquares) {
  const MultiPolygon a = Square(0, 0, 10), b = Square(5, 5, 10);
  EXPECT_EQ(AreaMm2(Union(a, b)), 175);
  EXPECT_EQ(AreaMm2(Intersection(a, b)), 25);
  EXPECT_EQ(AreaMm2(Difference(a, b)), 75);
}

TEST(Boolean, HoleInsideAndIslandInTheHole) {
  const MultiPolygon frame = Difference(Square(0, 0, 10), Square(2, 2, 6));
  ASSERT_EQ(frame.size(), 1u);
  EXPECT_EQ(frame[0].holes.size(), 1u);
  const MultiPolygon with_island = Union(frame, Square(4, 4, 2));
  ASSERT_EQ(with_island.size(), 2u);
  EXPECT_EQ(AreaMm2(with_island), 100 - 36 + 4);
  EXPECT_LT(SignedArea(with_island[0].holes[0]), 0);
  EXPECT_GT(SignedArea(with_island[0].outer), 0);
}

TEST(Boolean, DisjointAndEmptyOperands) {
  const MultiPolygon a = Square(0, 0, 1), b = Square(5, 5, 1);
  EXPECT_TRUE(Intersection(a, b).empty());
  EXPECT_EQ(Difference(a, b), a);
  EXPECT_EQ(Union(a, {}), a);
  EXPECT_TRUE(Difference({}, a).empty());
}

struct RuleCase {
  std::string name;
  FillRule rule;
  double want_mm2;
};
class FillRuleTest : public testing::TestWithParam<RuleCase> {};

// Two nested shells with the same direction, and a shell with the opposite direction beside them.
TEST_P(FillRuleTest, DecidesWhatIsInside) {
  std::vector<Polygon> rings = {Square(0, 0, 10)[0].outer, Square(2, 2, 4)[0].outer,
                                Square(20, 0, 3)[0].outer};
  std::reverse(rings[2].begin(), rings[2].end());
  EXPECT_EQ(AreaMm2(Union(rings, GetParam().rule)), GetParam().want_mm2);
}

INSTANTIATE_TEST_SUITE_P(Rules, FillRuleTest,
                         testing::Values(RuleCase{"NonZero", FillRule::kNonZero, 109},
                                         RuleCase{"EvenOdd", FillRule::kEvenOdd, 93},
                                         RuleCase{"Positive", FillRule::kPositive, 100}),
                         [](const auto& info) { return info.param.name; });

TEST(Boolean, ResultsAreCanonical) {
  const MultiPolygon a = Square(0, 0, 10), b = Square(5, 5, 10), c = Square(40, 0, 1);
  MultiPolygon ab = Union(Union(a, b), c), ba = Union(c, Union(b, a));
  EXPECT_EQ(ab, ba);
}

// Clipper lists the hole that b widens as a separate island with a negative area.
TEST(Difference, KeepsAHoleThatBWidens) {
  const MultiPolygon a = MakePolygonsOrDie(
      "(-8.768464 -14.708185, 40.491988 6.201635, 25.549430 41.404093, 22.570245 42.607765)"
      "(22.444898 41.476541, 22.931037 41.466094, 23.412365 41.397124)");
  const MultiPolygon b = MakePolygonsOrDie(
      "(18.432873 37.299429, 22.444898 41.476541, 22.931037 41.466094, 23.412365 41.397124, "
      "22.570245 "
      "42.607765) ; (34.678465 3.733941, 37.740767 6.165082, 34.871029 4.893700)");
  const MultiPolygon left = Difference(a, b);
  for (const PolygonWithHoles& island : left) EXPECT_GT(SignedArea(island.outer), 0);
  EXPECT_NEAR(Area(left), Area(a) - Area(Intersection(a, b)), 1e9);
  EXPECT_NEAR(Area(Intersection(left, b)), 0, 1e9);
}

}  // namespace
}  // namespace slicefarm::boolean_test
