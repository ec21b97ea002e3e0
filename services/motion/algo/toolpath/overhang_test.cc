#include "services/motion/algo/toolpath/overhang.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/measure.h"

namespace slicefarm::motion::overhang_test {
namespace {

constexpr Coord kWidth = 400'000;

/// Returns a square of 20 x 20 mm with a hole of 4 x 4 mm in the middle.
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
  EXPECT_EQ(below.RestOf(Mm(5, 5), kWidth), 1);
  EXPECT_EQ(below.RestOf(Mm(0.2, 5), kWidth), 1);
  EXPECT_EQ(below.RestOf(Mm(0.1, 5), kWidth), 0.75);
  EXPECT_EQ(below.RestOf(Mm(0, 5), kWidth), 0.5);
  EXPECT_EQ(below.RestOf(Mm(-0.1, 5), kWidth), 0.25);
  EXPECT_EQ(below.RestOf(Mm(-0.2, 5), kWidth), 0);
  EXPECT_EQ(below.RestOf(Mm(10, 10), kWidth), 0) << "over the hole";
  EXPECT_EQ(below.RestOf(Mm(10, 7.9), kWidth), 0.75);
  EXPECT_EQ(below.RestOf(Mm(50, 50), kWidth), 0);
  EXPECT_EQ(below.RestOf(Mm(10, -0.1), kWidth), 0.25);
  EXPECT_EQ(below.RestOf(Mm(10, 20.1), kWidth), 0.25);
}

/// Returns teeth, a slanted hole and an island in it. All corners are at whole quarters of a
/// millimetre.
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

/// Returns the pieces of a straight wall.
std::vector<RestingPiece> PiecesOf(const LayerBelow& below, RestSteps steps, Point from, Point to,
                                   Coord width_nm = kWidth) {
  const PathSegment wall = {from, to, width_nm};
  return PiecesOver(below, steps, {&wall, 1});
}

TEST(PiecesOver, CutsWhereTheRestChanges) {
  const LayerBelow below(Frame());
  const auto within = PiecesOf(below, RestSteps::kAll, Mm(2, 5), Mm(18, 5));
  ASSERT_EQ(within.size(), 1);
  EXPECT_EQ(within[0].to, Mm(18, 5));
  const auto over = PiecesOf(below, RestSteps::kAll, Mm(2, 10), Mm(18, 10));
  ASSERT_EQ(over.size(), 7);
  EXPECT_EQ(over[0].to, Mm(7, 10));
  EXPECT_EQ(over[0].rest, kFullRest);
  EXPECT_EQ(over[1].rest, 75);
  EXPECT_EQ(over[2].rest, 25);
  EXPECT_EQ(over[3].rest, 0);
  EXPECT_EQ(over[3].to, Mm(11, 10));
  EXPECT_EQ(over[6].to, Mm(18, 10));
}

TEST(PiecesOver, CutsWhereNothingRestsIfThatIsAll) {
  const LayerBelow below(Frame());
  const auto over = PiecesOf(below, RestSteps::kAirAlone, Mm(2, 10), Mm(18, 10));
  ASSERT_EQ(over.size(), 3);
  EXPECT_EQ(over[0].rest, kFullRest);
  EXPECT_EQ(over[1].rest, 0);
  EXPECT_EQ(over[1].to, Mm(11, 10));
  EXPECT_EQ(over[2].rest, kFullRest);
}

/// Returns a line along the outer edge that alternates between two distances from it.
std::vector<PathSegment> Wavering(double out_mm, double by_mm) {
  std::vector<PathSegment> wall;
  Point from = Mm(1, -out_mm);
  for (int i = 1; i < 15; ++i) {
    const Point to = Mm(1 + i, -out_mm - (i % 3 == 0 ? by_mm : 0));
    wall.push_back({from, to, kWidth});
    from = to;
  }
  return wall;
}

TEST(PiecesOver, AWallThatHangsOverEvenlyRestsAlike) {
  const LayerBelow below(Frame());
  for (const double out_mm : {-0.09, -0.042, 0.0, 0.031, 0.104}) {
    const auto wall = Wavering(out_mm, 0.018);
    const auto pieces = PiecesOver(below, RestSteps::kAll, wall);
    ASSERT_EQ(pieces.size(), wall.size());
    for (const RestingPiece& piece : pieces) EXPECT_EQ(piece.rest, pieces[0].rest) << out_mm;
    EXPECT_NEAR(pieces[0].rest, 50 - (out_mm + 0.009) / 0.4 * 100, 1.5) << out_mm;
  }
  const auto pieces = PiecesOver(below, RestSteps::kAll, Wavering(0, 0.06));
  const auto [least, most] = std::ranges::minmax(pieces, {}, &RestingPiece::rest);
  EXPECT_LT(least.rest, most.rest) << "more than that is told apart";
}

/// The wall's own bridge, and the part without slow-down, begin at the same places as before.
TEST(PiecesOver, NothingAndAllAreNotAveraged) {
  const LayerBelow below(Frame());
  const std::vector<PathSegment> wall = {{Mm(1, -0.2), Mm(2, -0.2), kWidth},
                                         {Mm(2, -0.2), Mm(3, -0.17), kWidth},
                                         {Mm(3, -0.17), Mm(4, -0.17), kWidth}};
  const auto over = PiecesOver(below, RestSteps::kAll, wall);
  EXPECT_EQ(over[0].rest, 0);
  EXPECT_GT(over[2].rest, 0);
  const std::vector<PathSegment> inner = {{Mm(1, 0.17), Mm(2, 0.17), kWidth},
                                          {Mm(2, 0.17), Mm(3, 0.2), kWidth},
                                          {Mm(3, 0.2), Mm(4, 0.2), kWidth}};
  const auto under = PiecesOver(below, RestSteps::kAll, inner);
  EXPECT_LT(under[0].rest, kFullRest);
  EXPECT_EQ(under[2].rest, kFullRest);
}

TEST(PiecesOver, ForgetsNoWidth) {
  const LayerBelow below(Frame());
  const Point from = Mm(7.8, 9), to = Mm(8.2, 9);
  const std::vector<PathSegment> both = {{from, to, kWidth}, {to, from, 4 * kWidth}};
  EXPECT_EQ(PiecesOver(below, RestSteps::kAll, both).back().rest,
            PiecesOf(below, RestSteps::kAll, to, from, 4 * kWidth).front().rest);
}

TEST(ByRest, GoesInProportionBetweenDegrees) {
  const std::array<double, 4> speeds = {10, 20, 40, 50};
  EXPECT_EQ(ByRest(speeds, 100, 0), 10);
  EXPECT_EQ(ByRest(speeds, 100, 25), 20);
  EXPECT_EQ(ByRest(speeds, 100, 40), 32);
  EXPECT_EQ(ByRest(speeds, 100, 75), 50);
  EXPECT_EQ(ByRest(speeds, 100, 90), 80);
  EXPECT_EQ(ByRest(speeds, 100, kFullRest), 100);
}

}  // namespace
}  // namespace slicefarm::motion::overhang_test
