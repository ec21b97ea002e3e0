#include "services/motion/algo/toolpath/overhang.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/measure.h"

namespace slicefarm::motion::overhang_test {
namespace {

constexpr Coord kWidth = 400'000;

/// 20 x 20 mm with a hole of 4 x 4 mm in the middle.
MultiPolygon Frame() {
  const auto square = [](double low, double high) {
    return Polygon{{FromMm(low), FromMm(low)},
                   {FromMm(high), FromMm(low)},
                   {FromMm(high), FromMm(high)},
                   {FromMm(low), FromMm(high)}};
  };
  Polygon hole = square(8, 12);
  std::ranges::reverse(hole);
  return {{square(0, 20), {hole}}};
}

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

TEST(LayerBelow, BeadsRestByTheirPlace) {
  const LayerBelow below(Frame());
  EXPECT_EQ(below.RestOf(Mm(5, 5), kWidth), kFullRest);
  EXPECT_EQ(below.RestOf(Mm(0.2, 5), kWidth), kFullRest);
  EXPECT_EQ(below.RestOf(Mm(0.1, 5), kWidth), 15);
  EXPECT_EQ(below.RestOf(Mm(0, 5), kWidth), 10);
  EXPECT_EQ(below.RestOf(Mm(-0.1, 5), kWidth), 5);
  EXPECT_EQ(below.RestOf(Mm(-0.2, 5), kWidth), 0);
  EXPECT_EQ(below.RestOf(Mm(10, 10), kWidth), 0) << "over the hole";
  EXPECT_EQ(below.RestOf(Mm(10, 7.9), kWidth), 15);
  EXPECT_EQ(below.RestOf(Mm(50, 50), kWidth), 0);
  EXPECT_EQ(below.RestOf(Mm(10, -0.1), kWidth), 5);
  EXPECT_EQ(below.RestOf(Mm(10, 20.1), kWidth), 5);
}

/// Teeth, a slanted hole and an island in it; corners in whole quarters of a millimetre.
MultiPolygon Comb() {
  Polygon outer = {{FromMm(-3), FromMm(-2)}, {FromMm(33), FromMm(-2)}};
  for (int tooth = 10; tooth >= 0; --tooth) {
    outer.push_back(Mm(3 * tooth + 2, 12.25));
    outer.push_back(Mm(3 * tooth + 0.25, tooth % 2 == 0 ? 8 : 10.5));
  }
  const Polygon hole = {Mm(0, 0), Mm(2, 5), Mm(20, 6), Mm(28, 0)};
  const Polygon island = {Mm(4, 1), Mm(20, 1.25), Mm(10, 4.5)};
  return {{outer, {hole}}, {island, {}}};
}

TEST(LayerBelow, CoversWhatLiesInTheOutlines) {
  for (const MultiPolygon& outlines : {Frame(), Comb()}) {
    const LayerBelow below(outlines);
    int inside = 0, outside = 0;
    for (Coord x = FromMm(-5); x < FromMm(36); x += 93'750) {
      for (Coord y = FromMm(-4); y < FromMm(22); y += 125'000) {
        bool is_inside = false, on_edge = false;
        for (const PolygonWithHoles& island : outlines) {
          const Side side = Locate({x, y}, island);
          is_inside |= side == Side::kInside;
          on_edge |= side == Side::kBoundary;
        }
        if (on_edge) continue;
        EXPECT_EQ(below.Covers({x, y}), is_inside) << ToMm(x) << " " << ToMm(y);
        ++(is_inside ? inside : outside);
      }
    }
    EXPECT_GT(inside, 10'000);
    EXPECT_GT(outside, 10'000);
  }
}

TEST(LayerBelow, OverAirNothingRests) { EXPECT_EQ(LayerBelow({}).RestOf(Mm(0, 0), kWidth), 0); }

TEST(PiecesOf, CutsWhereTheRestChanges) {
  const LayerBelow below(Frame());
  RestAlong along(below, RestSteps::kAll);
  const auto within = along.PiecesOf(Mm(2, 5), Mm(18, 5), kWidth);
  ASSERT_EQ(within.size(), 1);
  EXPECT_EQ(within[0].to, Mm(18, 5));
  const auto over = along.PiecesOf(Mm(2, 10), Mm(18, 10), kWidth);
  ASSERT_EQ(over.size(), 7);
  EXPECT_EQ(over[0].to, Mm(7, 10));
  EXPECT_EQ(over[0].rest, kFullRest);
  EXPECT_EQ(over[1].rest, 15);
  EXPECT_EQ(over[2].rest, 5);
  EXPECT_EQ(over[3].rest, 0);
  EXPECT_EQ(over[3].to, Mm(11, 10));
  EXPECT_EQ(over[6].to, Mm(18, 10));
}

TEST(PiecesOf, CutsWhereNothingRestsIfThatIsAll) {
  const LayerBelow below(Frame());
  RestAlong along(below, RestSteps::kAirAlone);
  const auto over = along.PiecesOf(Mm(2, 10), Mm(18, 10), kWidth);
  ASSERT_EQ(over.size(), 3);
  EXPECT_EQ(over[0].rest, kFullRest);
  EXPECT_EQ(over[1].rest, 0);
  EXPECT_EQ(over[1].to, Mm(11, 10));
  EXPECT_EQ(over[2].rest, kFullRest);
}

TEST(PiecesOf, ForgetsNoWidth) {
  const LayerBelow below(Frame());
  RestAlong along(below, RestSteps::kAll);
  const Point from = Mm(7.8, 9), to = Mm(8.2, 9);
  along.PiecesOf(from, to, kWidth);
  EXPECT_EQ(along.PiecesOf(to, from, 4 * kWidth).front().rest,
            RestAlong(below, RestSteps::kAll).PiecesOf(to, from, 4 * kWidth).front().rest);
}

TEST(ByRest, GoesInProportionBetweenDegrees) {
  const std::array<double, 4> speeds = {10, 20, 40, 50};
  EXPECT_EQ(ByRest(speeds, 100, 0), 10);
  EXPECT_EQ(ByRest(speeds, 100, 5), 20);
  EXPECT_EQ(ByRest(speeds, 100, 8), 32);
  EXPECT_EQ(ByRest(speeds, 100, 15), 50);
  EXPECT_EQ(ByRest(speeds, 100, 18), 80);
  EXPECT_EQ(ByRest(speeds, 100, kFullRest), 100);
}

}  // namespace
}  // namespace slicefarm::motion::overhang_test
