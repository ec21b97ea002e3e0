#include "services/planning/algo/curl/curled_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "common/geometry/covers.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::planning::curled_edges_test {
namespace {

constexpr Coord kWidthNm = 450'000;
constexpr Coord kHeightNm = 200'000;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

MultiPolygon Square(double half) {
  return {{{Mm(-half, -half), Mm(half, -half), Mm(half, half), Mm(-half, half)}, {}}};
}

Polygon Circle(double radius, int points = 200) {
  Polygon ring;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    ring.push_back(Mm(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return ring;
}

MultiPolygon Disc(double radius, int points = 200) { return {{Circle(radius, points), {}}}; }

/// Returns a plate of 40 mm with a hole.
MultiPolygon Holed(double radius) {
  MultiPolygon plate = Square(20);
  Polygon hole = Circle(radius);
  std::ranges::reverse(hole);
  plate.front().holes = {hole};
  return plate;
}

/// Returns the curled areas of each layer.
std::vector<MultiPolygon> Curled(const std::vector<MultiPolygon>& outlines,
                                 const MultiPolygon& above_supports = {}) {
  CurledEdges edges(kWidthNm);
  std::vector<MultiPolygon> areas;
  for (const MultiPolygon& outline : outlines)
    areas.push_back(edges.Next(outline, above_supports, kHeightNm));
  return areas;
}

struct Case {
  std::string name;
  std::vector<MultiPolygon> outlines;
  bool curls = false;  ///< expected result in the topmost layer
};

class CurledEdgesTest : public testing::TestWithParam<Case> {};

TEST_P(CurledEdgesTest, CurlsWhereTheEdgeOfAnOverhangTurnsOutwards) {
  EXPECT_EQ(!Curled(GetParam().outlines).back().empty(), GetParam().curls);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, CurledEdgesTest,
    testing::Values(Case{"OnTheBed", {Disc(5)}}, Case{"Upright", {Disc(5), Disc(5)}},
                    Case{"Cone", {Disc(5), Disc(5.3)}, true},
                    Case{"ConeOfAGreatRadius", {Disc(60), Disc(60.3)}},
                    // The facets are 2.5 mm long, and their corners do not count as corners.
                    Case{"ConeOfFacets", {Disc(60, 150), Disc(60.3, 150)}},
                    Case{"HardlyHangsOver", {Disc(5), Disc(5.08)}},
                    Case{"Narrows", {Disc(5), Disc(4.7)}}, Case{"ALedgeSags", {Disc(5), Disc(7)}},
                    Case{"Corners", {Square(5), Square(5.3)}, true},
                    Case{"AHoleCloses", {Holed(5), Holed(4.7)}},
                    Case{"NothingBelow", {MultiPolygon{}, Disc(5)}}, Case{"Nothing", {{}, {}}},
                    Case{"NothingAbove", {Disc(5), MultiPolygon{}}}),
    [](const auto& info) { return info.param.name; });

TEST(CurledEdges, StraightEdgesLieStill) {
  const MultiPolygon area = Curled({Square(5), Square(5.3)}).back();
  EXPECT_EQ(area.size(), 4U);
  EXPECT_TRUE(Covers(area, Mm(5.3, 5.3)));
  EXPECT_FALSE(Covers(area, Mm(5.3, 0)));
  EXPECT_FALSE(Covers(area, Mm(4, 4)));
}

TEST(CurledEdges, TheAreaIsAWidthAround) {
  const MultiPolygon area = Curled({Disc(5), Disc(5.3)}).back();
  const double ring_mm2 = 2 * std::numbers::pi * 5.3 * 2 * 0.45;
  EXPECT_NEAR(Area(area) / kNmPerMm / kNmPerMm, ring_mm2, 0.05 * ring_mm2);
}

TEST(CurledEdges, WhatSupportsCarryLiesStill) {
  EXPECT_TRUE(Curled({Disc(5), Disc(5.3)}, Square(20)).back().empty());
}

// The edge is 0.28 mm above its layer. Each layer over it presses it down by 0.15 mm.
TEST(CurledEdges, FadesUnderWhatGoesOverIt) {
  const auto areas = Curled({Disc(5), Disc(5.3), Disc(5.3), Disc(5.3)});
  EXPECT_FALSE(areas[1].empty());
  EXPECT_FALSE(areas[2].empty());
  EXPECT_TRUE(areas[3].empty());
}

// The edge rises by 0.08 mm per layer, and the next layer presses it flat.
TEST(CurledEdges, ALittleIsPressedFlat) {
  CurledEdges edges(kWidthNm);
  for (int i = 0; i < 50; ++i)
    EXPECT_TRUE(edges.Next(Disc(10 + 0.16 * i), {}, kHeightNm).empty()) << i;
}

// The edge rises by about 0.35 mm per layer, and the next layer leaves 0.2 mm of it. The total is
// at most 2 mm, which vanishes after twelve layers.
TEST(CurledEdges, GrowsFromLayerToLayerUpToTenOfThem) {
  CurledEdges edges(kWidthNm);
  edges.Next(Disc(10), {}, kHeightNm);
  for (int i = 1; i <= 20; ++i)
    EXPECT_FALSE(edges.Next(Disc(10 + 0.4 * i), {}, kHeightNm).empty()) << i;
  for (int i = 1; i <= 14; ++i) EXPECT_EQ(edges.Next(Disc(18), {}, kHeightNm).empty(), i > 12) << i;
}

TEST(CurledEdges, StaysWhereNothingGoesOverIt) {
  const auto areas = Curled({Square(5), Square(5.4), Square(1), Square(1)});
  ASSERT_FALSE(areas[2].empty());
  EXPECT_TRUE(Covers(areas[2], Mm(5.4, 5.4)));
  EXPECT_TRUE(areas[3].empty()) << "0.4 mm are no more than two layers";
}

TEST(CurledEdges, TurnsWithThePart) {
  const MultiPolygon below = MakePolygonsOrDie("(0 0, 30 0, 30 9, 12 9, 12 20, 0 20)");
  const MultiPolygon above =
      MakePolygonsOrDie("(-0.3 -0.3, 30.3 -0.3, 30.3 9.3, 12.3 9.3, 12.3 20.3, -0.3 20.3)");
  const auto turned = [](MultiPolygon polygons) {
    for (Point& p : polygons.front().outer) p = {-p.y, p.x};
    return polygons;
  };
  const double as_it_is = Area(Curled({below, above}).back());
  EXPECT_GT(as_it_is, 0);
  EXPECT_NEAR(Area(Curled({turned(below), turned(above)}).back()), as_it_is, 0.02 * as_it_is);
}

}  // namespace
}  // namespace slicefarm::planning::curled_edges_test
