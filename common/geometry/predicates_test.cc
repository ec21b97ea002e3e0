#include "common/geometry/predicates.h"

#include <gtest/gtest.h>

#include <limits>

namespace slicefarm::predicates_test {
namespace {

constexpr Coord kMax = std::numeric_limits<Coord>::max();
constexpr Coord kMin = std::numeric_limits<Coord>::min();
/// About one metre: the limit up to which 64 bits suffice.
constexpr Coord kMetre = Coord{1} << 30;

struct Case {
  std::string name;
  Point a, b, c;
  int want;
};

class OrientationTest : public testing::TestWithParam<Case> {};

TEST_P(OrientationTest, IsExactInEveryOrder) {
  const auto& [name, a, b, c, want] = GetParam();
  EXPECT_EQ(Orientation(a, b, c), want);
  EXPECT_EQ(Orientation(b, c, a), want);
  EXPECT_EQ(Orientation(c, a, b), want);
  EXPECT_EQ(Orientation(b, a, c), -want);
}

INSTANTIATE_TEST_SUITE_P(
    Predicates, OrientationTest,
    testing::Values(
        Case{"Unit", {0, 0}, {1, 0}, {0, 1}, 1},  // errata 10.1.4
        Case{"Line", {0, 0}, {1, 1}, {2, 2}, 0}, Case{"Same", {5, 5}, {5, 5}, {7, 9}, 0},
        Case{"OneUnitOffALongLine", {0, 0}, {2'100'000'000, 1}, {4'200'000'000, 1}, -1},
        Case{"CornersOfTwoMetres",
             {-kMetre, -kMetre},
             {kMetre - 1, -kMetre},
             {kMetre - 1, kMetre - 1},
             1},
        Case{"AcrossTwoMetres", {-kMetre, -kMetre}, {0, 0}, {kMetre - 1, kMetre - 1}, 0},
        Case{"AcrossTwoMetresOneOff", {-kMetre, -kMetre}, {0, 0}, {kMetre - 1, kMetre - 2}, -1},
        Case{"AcrossTwoMetresAndMore", {-kMetre, -kMetre}, {1, 1}, {kMetre + 1, kMetre}, -1},
        Case{"WholeRange", {kMin, kMin}, {kMax, kMin}, {kMax, kMax}, 1},
        Case{"WholeRangeLine", {kMin, kMin}, {0, 0}, {kMax, kMax}, 0},
        Case{"WholeRangeOneOff", {kMin, kMin}, {0, 0}, {kMax, kMax - 1}, -1}),
    [](const auto& info) { return info.param.name; });

// The grid of Kettner et al., on which doubles give a wrong sign in one of six cases: a is near b
// and c on a line.
TEST(Orientation, AgreesWithTheSignOfTheExactDeterminantOnAFineGrid) {
  const Point b{Coord{12} << 40, Coord{12} << 40}, c{Coord{24} << 40, Coord{24} << 40};
  for (Coord i = 0; i < 256; ++i) {
    for (Coord j = 0; j < 256; ++j) {
      const Point a{(Coord{1} << 39) + i, (Coord{1} << 39) + j};
      EXPECT_EQ(Orientation(a, b, c), i < j ? 1 : i > j ? -1 : 0) << i << " " << j;
    }
  }
}

TEST(OnSegment, TakesEndsAndMiddleOnly) {
  EXPECT_TRUE(OnSegment({0, 0}, {0, 0}, {4, 2}));
  EXPECT_TRUE(OnSegment({2, 1}, {0, 0}, {4, 2}));
  EXPECT_TRUE(OnSegment({4, 2}, {0, 0}, {4, 2}));
  EXPECT_FALSE(OnSegment({6, 3}, {0, 0}, {4, 2}));
  EXPECT_FALSE(OnSegment({2, 2}, {0, 0}, {4, 2}));
}

}  // namespace
}  // namespace slicefarm::predicates_test
