#include "common/geometry/rings/simple_rings.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/text_format_test.h"

namespace slicefarm::simple_rings_test {
namespace {

struct SimpleCase {
  std::string name;
  std::string text;
  bool want;
};
class SimpleRings : public testing::TestWithParam<SimpleCase> {};

TEST_P(SimpleRings, AreToldFromOthers) {
  const MultiPolygon polygons = MakePolygonsOrDie(GetParam().text);
  std::vector<const Polygon*> rings;
  ForEachRing(polygons, [&](const Polygon& ring) { rings.push_back(&ring); });
  EXPECT_EQ(AreSimple(rings), GetParam().want);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, SimpleRings,
    testing::Values(
        SimpleCase{"Square", "(0 0, 4 0, 4 4, 0 4)", true},
        SimpleCase{"WithCollinearPoint", "(0 0, 2 0, 4 0, 4 4, 0 4)", true},
        SimpleCase{"SquareWithHole", "(0 0, 4 0, 4 4, 0 4) (1 1, 2 1, 2 2, 1 2)", true},
        SimpleCase{"TwoApart", "(0 0, 4 0, 4 4, 0 4) ; (5 0, 9 0, 9 4, 5 4)", true},
        SimpleCase{"BowTie", "(0 0, 4 4, 4 0, 0 3)", false},
        SimpleCase{"Spike", "(0 0, 4 0, 8 0, 4 0, 4 4, 0 4)", false},
        SimpleCase{"CornerOnEdge", "(0 0, 4 0, 2 2, 4 4, 0 4, 2 2)", false},
        SimpleCase{"TwiceThroughAPoint", "(0 0, 2 2, 4 0, 4 4, 2 2, 0 4)", false},
        SimpleCase{"HoleTouchesOuter", "(0 0, 4 0, 4 4, 0 4) (0 2, 1 1, 1 3)", false},
        SimpleCase{"HoleCrossesOuter", "(0 0, 4 0, 4 4, 0 4) (3 1, 5 1, 5 3, 3 3)", false},
        SimpleCase{"SharedCorner", "(0 0, 4 0, 4 4, 0 4) ; (4 4, 8 4, 8 8, 4 8)", false},
        SimpleCase{"SharedEdge", "(0 0, 4 0, 4 4, 0 4) ; (4 1, 8 1, 8 3, 4 3)", false},
        SimpleCase{"SameRingTwice", "(0 0, 4 0, 4 4, 0 4) ; (0 0, 4 0, 4 4, 0 4)", false}),
    [](const auto& info) { return info.param.name; });

TEST(SimpleRingsLimits, TooFewOrRepeatedPoints) {
  const Polygon two = {{0, 0}, {5, 5}}, repeated = {{0, 0}, {5, 0}, {5, 0}, {5, 5}};
  for (const Polygon* ring : {&two, &repeated})
    EXPECT_FALSE(AreSimple(std::vector<const Polygon*>{ring}));
}

// Thousands of edges side by side, but in one direction only.
TEST(SimpleRingsLimits, CombIsSimple) {
  Polygon comb;
  for (Coord i = 0; i < 2000; ++i) {
    comb.push_back({0 + i % 2, 2000 * i});
    comb.push_back({90'000'000, 2000 * i});
    comb.push_back({90'000'000, 2000 * i + 1000});
    comb.push_back({10, 2000 * i + 1000});
  }
  comb.push_back({-1000, 4'000'000});
  comb.push_back({-1000, 0});
  EXPECT_TRUE(AreSimple(std::vector<const Polygon*>{&comb}));
}

// Hundreds of edges side by side, in both directions.
TEST(SimpleRingsLimits, SlantedCombIsSimple) {
  Polygon comb;
  for (Coord i = 0; i < 200; ++i) {
    const Coord x = 2000 * i, y = -2000 * i;
    comb.push_back({x + i % 2, y});
    comb.push_back({x + 90'000'000, y + 90'000'000});
    comb.push_back({x + 90'001'000, y + 89'999'000});
    comb.push_back({x + 1010, y - 990});
  }
  comb.push_back({0, -1'000'000});
  EXPECT_TRUE(AreSimple(std::vector<const Polygon*>{&comb}));
}

}  // namespace
}  // namespace slicefarm::simple_rings_test
