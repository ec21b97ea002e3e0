#include "services/slicing/algo/section/loop_nesting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::loop_nesting_test {
namespace {

Polygon Square(Coord x, Coord y, Coord size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}
Polygon Clockwise(Polygon ring) { return {ring.rbegin(), ring.rend()}; }

struct Case {
  std::string name;
  std::vector<Polygon> loops;
};

std::vector<Case> SimpleCases() {
  std::vector<Polygon> many;
  for (Coord i = 0; i < 20; ++i)
    for (Coord j = 0; j < 20; ++j) many.push_back(Square(20 * i + j % 3, 20 * j + i % 5, 10));
  many.push_back(Square(-100, -100, 1000));
  for (Coord i = 0; i < 400; i += 2)
    many[static_cast<size_t>(i)] = Clockwise(many[static_cast<size_t>(i)]);
  return {
      {"None", {}},
      {"One", {Square(0, 0, 9)}},
      {"Hole", {Square(0, 0, 90), Clockwise(Square(10, 10, 9))}},
      {"HoleFirst", {Clockwise(Square(10, 10, 9)), Square(0, 0, 90)}},
      {"IslandInHole", {Square(0, 0, 90), Clockwise(Square(10, 10, 70)), Square(20, 20, 9)}},
      {"Inverted", {Clockwise(Square(0, 0, 90))}},
      {"InvertedWithHole", {Clockwise(Square(0, 0, 90)), Square(10, 10, 9)}},
      {"SameWay", {Square(0, 0, 90), Square(10, 10, 9)}},
      {"SameWayTwice", {Square(0, 0, 90), Square(10, 10, 70), Square(20, 20, 9)}},
      {"TwoInARow", {Square(0, 0, 9), Square(20, 0, 9)}},
      {"TwoInAColumn", {Square(0, 0, 9), Square(0, 20, 9)}},
      {"ThreeInAColumnNested",
       {Square(-5, -5, 100), Clockwise(Square(0, 0, 9)), Clockwise(Square(0, 20, 9)),
        Clockwise(Square(0, 40, 9))}},
      {"Diamonds",
       {{{0, -50}, {50, 0}, {0, 50}, {-50, 0}}, {{0, 20}, {-20, 0}, {0, -20}, {20, 0}}}},
      {"InTheCornerOfAnL",
       {{{0, 0}, {90, 0}, {90, 10}, {10, 10}, {10, 90}, {0, 90}}, Square(20, 20, 9)}},
      {"UnderARoof", {{{0, 0}, {50, 50}, {100, 0}, {100, 60}, {0, 60}}, Square(45, 10, 10)}},
      {"Many", many},
  };
}

TEST(NestSimpleLoops, AgreesWithUnionUnderEveryRule) {
  for (const Case& c : SimpleCases()) {
    for (const FillRule rule : {FillRule::kNonZero, FillRule::kEvenOdd, FillRule::kPositive}) {
      const std::optional<MultiPolygon> nested = NestSimpleLoops(c.loops, rule);
      ASSERT_TRUE(nested.has_value()) << c.name;
      EXPECT_EQ(*nested, Union(c.loops, rule))
          << c.name << static_cast<int>(rule) << ToText(*nested);
    }
  }
}

TEST(NestSimpleLoops, DoesNotDependOnTheOrder) {
  for (Case& c : SimpleCases()) {
    const auto want = NestSimpleLoops(c.loops, FillRule::kNonZero);
    std::reverse(c.loops.begin(), c.loops.end());
    for (Polygon& loop : c.loops) std::rotate(loop.begin(), loop.begin() + 1, loop.end());
    EXPECT_EQ(NestSimpleLoops(c.loops, FillRule::kNonZero), want) << c.name;
  }
}

TEST(NestSimpleLoops, LeavesWhatMeetsToUnion) {
  const std::vector<Case> cases = {
      {"Crossing", {Square(0, 0, 10), Square(5, 5, 10)}},
      {"TouchingInACorner", {Square(0, 0, 10), Square(10, 10, 10)}},
      {"TouchingASide", {Square(0, 0, 10), Square(10, 2, 5)}},
      {"CornerOnASide", {Square(0, 0, 10), {{10, 5}, {20, 0}, {20, 10}}}},
      {"TheSameTwice", {Square(0, 0, 10), Square(0, 0, 10)}},
      {"Bowtie", {{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}},
      {"CornerOnItself", {{{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}}},
      {"EightInAPoint", {{{0, 0}, {5, 5}, {10, 0}, {10, 10}, {5, 5}, {0, 10}}}},
      {"OverlapOfSides", {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{2, 10}, {8, 10}, {5, 20}}}},
  };
  for (const Case& c : cases)
    EXPECT_FALSE(NestSimpleLoops(c.loops, FillRule::kNonZero).has_value()) << c.name;
}

TEST(NestSimpleLoops, IsExactAtTheLimits) {
  constexpr Coord kFar = 2'100'000'000;
  const Polygon upper = {{-kFar, -kFar}, {kFar, kFar - 1}, {-kFar, kFar}};
  const Polygon lower = {{-kFar + 1, -kFar}, {kFar, -kFar}, {kFar, kFar - 2}};
  EXPECT_TRUE(NestSimpleLoops({upper, lower}, FillRule::kNonZero).has_value());
  const Polygon touching = {{-kFar, -kFar}, {kFar, -kFar}, {kFar, kFar - 2}};
  EXPECT_FALSE(NestSimpleLoops({upper, touching}, FillRule::kNonZero).has_value());
}

/// A comb of many long teeth must be nested or refused, but within a short time.
TEST(NestSimpleLoops, GivesUpOnWhatIsTooDense) {
  std::vector<Polygon> teeth;
  for (Coord i = 0; i < 2'000; ++i)
    teeth.push_back({{-10'000 - i, 10 * i}, {10'000, 10 * i}, {10'000, 10 * i + 5}});
  EXPECT_FALSE(NestSimpleLoops(teeth, FillRule::kNonZero).has_value());
}

}  // namespace
}  // namespace slicefarm::slicing::loop_nesting_test
