#include "services/slicing/algo/section/elephant_foot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/text_format_test.h"
#include "services/slicing/algo/section/local_width.h"

namespace slicefarm::slicing::elephant_foot_test {
namespace {

constexpr Coord kFoot = 200'000;
constexpr Coord kMin = 757'000;

MultiPolygon P(const std::string& text) { return MakePolygonsOrDie(text); }
double Mm2(const MultiPolygon& region) { return Area(region) * 1e-12; }
MultiPolygon Foot(const MultiPolygon& outlines) {
  return ElephantFootCompensated(outlines, kFoot, kMin);
}

/// Returns a blade of this width that stands on a block.
MultiPolygon Blade(double width_mm) {
  const Coord half = FromMm(width_mm / 2), mm = kNmPerMm;
  return {{{{-10 * mm, -10 * mm},
            {10 * mm, -10 * mm},
            {10 * mm, 0},
            {half, 0},
            {half, 15 * mm},
            {-half, 15 * mm},
            {-half, 0},
            {-10 * mm, 0}},
           {}}};
}

/// Returns the remaining width along a line across the blade, in mm.
double WidthAcross(const MultiPolygon& region, double y_mm) {
  const Coord y = FromMm(y_mm), reach = 9'000'000;
  const MultiPolygon strip = {
      {{{-reach, y}, {reach, y}, {reach, y + 1000}, {-reach, y + 1000}}, {}}};
  return Area(Intersection(region, strip)) * 1e-9;  // a strip 1 um high
}

// PrusaSlicer 2.5.0 gives 0.4, 0.5, 0.6, 0.758, 0.758, 0.799, 1.1, 1.6, 2.6.
TEST(ElephantFoot, BladesKeepTheirWidthWhereTheyAreThin) {
  const std::vector<std::pair<double, double>> cases = {
      {0.05, 0.05}, {0.4, 0.4}, {0.5, 0.5}, {0.6, 0.6}, {0.8, 0.757},
      {1.0, 0.757}, {1.2, 0.8}, {1.5, 1.1}, {2.0, 1.6}, {3.0, 2.6}};
  for (const auto& [width, left] : cases) {
    const MultiPolygon foot = Foot(Blade(width));
    ASSERT_EQ(foot.size(), 1u) << width;
    for (const double y : {2.0, 7.0, 12.0}) EXPECT_NEAR(WidthAcross(foot, y), left, 0.003) << width;
    EXPECT_EQ(Bounds(foot).min, (Point{-9'800'000, -9'800'000})) << width;
    EXPECT_EQ(Bounds(foot).max.y, 14'800'000) << width;
  }
}

struct Case {
  std::string name, outlines;
  double mm2;
};

TEST(ElephantFoot, OfKnownShapes) {
  const double corner = (1 - 3.14159265 / 4) * 0.04;  // area left by a square hole's round corner
  const std::vector<Case> cases = {
      {"Nothing", "", 0},
      {"Square", "(0 0, 10 0, 10 10, 0 10)", 9.6 * 9.6},
      {"Frame", "(0 0, 20 0, 20 20, 0 20) (5 5, 15 5, 15 15, 5 15)",
       19.6 * 19.6 - 10.4 * 10.4 + 4 * corner},
      {"IslandInAHole",
       "(0 0, 20 0, 20 20, 0 20) (5 5, 15 5, 15 15, 5 15) ; (8 8, 12 8, 12 12, 8 12)",
       19.6 * 19.6 - 10.4 * 10.4 + 4 * corner + 3.6 * 3.6},
      {"Pin", "(0 0, 0.5 0, 0.5 0.5, 0 0.5)", 0.25},
      {"PinAboveTheLimit", "(0 0, 0.9 0, 0.9 0.9, 0 0.9)", 0.757 * 0.757},
      {"SmallTriangle", "(0 0, 0.5 0, 0.25 0.433)", 0.10825},
      {"ThinFrame", "(0 0, 20 0, 20 20, 0 20) (0.5 0.5, 19.5 0.5, 19.5 19.5, 0.5 19.5)", 400 - 361},
      {"CornersOf60", "(0 0, 20 0, 10 17.320508)", 173.20508 * std::pow(1 - 0.2 / 5.773503, 2)},
  };
  for (const Case& c : cases) {
    const MultiPolygon outlines = c.outlines.empty() ? MultiPolygon{} : P(c.outlines);
    EXPECT_NEAR(Mm2(Foot(outlines)), c.mm2, 0.003 + c.mm2 * 1e-4) << c.name;
  }
}

TEST(ElephantFoot, WedgesRampUp) {
  const MultiPolygon wedge = P("(0 -0.05, 40 -1.5, 40 1.5, 0 0.05)");
  const MultiPolygon foot = Foot(wedge);
  ASSERT_EQ(foot.size(), 1u);
  double before = 0;
  for (double x = 0.5; x < 39; x += 0.5) {
    const double width = 0.1 + 2.9 * x / 40;
    const Coord at = FromMm(x);
    const MultiPolygon strip = {
        {{{at, -3'000'000}, {at + 1000, -3'000'000}, {at + 1000, 3'000'000}, {at, 3'000'000}}, {}}};
    const double left = Area(Intersection(foot, strip)) * 1e-9;
    EXPECT_NEAR(left, std::max(std::min(width, 0.757), width - 0.4), 0.006) << x;
    EXPECT_GE(left, before - 0.003) << x;
    before = left;
  }
}

TEST(ElephantFoot, ADoorStaysOpen) {
  const MultiPolygon rooms =
      P("(0 0, 10 0, 15 4.7, 20 0, 30 0, 30 10, 20 10, 15 5.3, 10 10, 0 10)");
  const MultiPolygon foot = Foot(rooms);
  ASSERT_EQ(foot.size(), 1u);
  // A disc of the door's width still fits through, to 10 um.
  const OffsetOptions round{.join = Join::kRound};
  EXPECT_EQ(Offset(foot, -295'000, round).size(), 1u);
  EXPECT_EQ(Offset(foot, -305'000, round).size(), 2u);
}

TEST(ElephantFoot, NothingToTakeOff) {
  const MultiPolygon box = P("(0 0, 10 0, 10 10, 0 10)");
  EXPECT_EQ(ElephantFootCompensated(box, 0, kMin), box);
  EXPECT_EQ(ElephantFootCompensated(box, -5, kMin), box);
  EXPECT_NEAR(Mm2(ElephantFootCompensated(box, kFoot, -1)), 9.6 * 9.6, 1e-6);
  EXPECT_EQ(ElephantFootCompensated(box, kFoot, 20'000'000), box);
  EXPECT_EQ(Foot(Foot({})), MultiPolygon{});
}

TEST(ElephantFoot, SurvivesHostileInput) {
  const MultiPolygon crumb = {{{{0, 0}, {1, 0}, {1, 1}}, {}}};
  EXPECT_EQ(Foot(crumb), crumb);
  const MultiPolygon thread = P("(0 0, 50 0, 50 0.00001, 0 0.00001)");
  EXPECT_EQ(Foot(thread).size(), 1u);
  // One case has islands that touch at a corner, the other a hole that touches its outline.
  EXPECT_EQ(Foot(P("(0 0, 5 0, 5 5, 0 5) ; (5 5, 9 5, 9 9, 5 9)")).size(), 2u);
  const MultiPolygon touching = P("(0 0, 10 0, 10 10, 0 10) (5 0, 7 4, 3 4)");
  const MultiPolygon foot = Foot(touching);
  EXPECT_EQ(foot.size(), 1u);
  EXPECT_LT(Mm2(Difference(foot, touching)), 1e-6);
}

/// Returns true if a disc touches the outline at p from the inside. Its diameter is the width from
/// which the full compensation applies.
bool IsWide(Point p, Vector2 inward, const MultiPolygon& island) {
  const double radius = (kMin + 2 * kFoot) / 2 + 5e3;
  const Point center{p.x + std::llround(inward.x() * radius),
                     p.y + std::llround(inward.y() * radius)};
  return Inside(center, island) && DistanceToBoundary(center, island) > radius - 100;
}

/// Returns true if no point up to 0.5 mm from the middle of an edge is thin. The shrinkage ramps up
/// over 0.4 mm.
bool IsWideAround(Point middle, Vector2 along, double length, const MultiPolygon& island) {
  if (length < 1.1e6) return false;
  for (double at = -5e5; at <= 5e5; at += 1e5) {
    const Point p{middle.x + std::llround(along.x() * at), middle.y + std::llround(along.y() * at)};
    if (!IsWide(p, {-along.y(), along.x()}, island)) return false;
  }
  return true;
}

/// Checks wide places and returns the number of places checked.
int ExpectWidePlacesShrink(const MultiPolygon& island, const MultiPolygon& foot, int trial) {
  int wide = 0;
  ForEachRing(island, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      const Point p{(a.x + b.x) / 2, (a.y + b.y) / 2};
      const double length = Distance(a, b);
      const Vector2 along{static_cast<double>(b.x - a.x) / length,
                          static_cast<double>(b.y - a.y) / length};
      if (!IsWideAround(p, along, length, island)) continue;
      ++wide;
      const auto at = [&](double depth) {
        return Point{p.x - std::llround(along.y() * depth), p.y + std::llround(along.x() * depth)};
      };
      EXPECT_FALSE(Inside(at(kFoot - 2e3), foot)) << trial << ToText(p);
      EXPECT_TRUE(Inside(at(kFoot + 2e3), foot)) << trial << ToText(p);
    }
  });
  return wide;
}

TEST(ElephantFoot, KeepsItsPromisesOnRandomIslands) {
  std::mt19937 random(31);
  int wide = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const MultiPolygon outlines = RandomIsland(random, {}, Uniform(random, 0.5, 12));
    const MultiPolygon foot = Foot(outlines);
    ASSERT_EQ(foot.size(), outlines.size()) << trial << ToText(outlines);
    size_t holes = 0, holes_before = 0;
    for (const PolygonWithHoles& island : outlines) holes_before += island.holes.size();
    for (const PolygonWithHoles& island : foot) holes += island.holes.size();
    ASSERT_EQ(holes, holes_before) << trial;
    ForEachBoundaryPoint(foot, 5e5, [&](Point p) {
      ASSERT_LE(DistanceToBoundary(p, outlines), kFoot + 5) << trial << ToText(p);
      ASSERT_TRUE(Inside(p, outlines) || DistanceToBoundary(p, outlines) < 5) << trial;
    });
    for (int k = 0; k < 30; ++k) {
      const Point p = RandomPoint(random, Bounds(outlines));
      const bool deep = Inside(p, outlines) && DistanceToBoundary(p, outlines) > kFoot + 5;
      ASSERT_TRUE(!deep || Inside(p, foot)) << trial << ToText(p);
    }
    wide += ExpectWidePlacesShrink(outlines, foot, trial);
  }
  EXPECT_GT(wide, 1000);
}

/// The test measures the share of the material with min_width that loses this width.
TEST(ElephantFoot, LeavesTheMinimumWidth) {
  std::mt19937 random(32);
  double lost_mm2 = 0, all_mm2 = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const MultiPolygon outlines = RandomIsland(random, {}, Uniform(random, 2, 12));
    const MultiPolygon kernel = Offset(outlines, -kMin / 2, {.join = Join::kRound});
    const MultiPolygon left = Offset(Foot(outlines), -kMin / 2 + 10'000, {.join = Join::kRound});
    // The middle lines of areas that were wide enough must keep their width; only corners may lose
    // it.
    all_mm2 += Mm2(kernel);
    lost_mm2 += Mm2(Difference(Offset(kernel, -kFoot - 10'000, {.join = Join::kRound}), left));
  }
  EXPECT_GT(all_mm2, 1000);
  EXPECT_LT(lost_mm2, 1e-6 * all_mm2);
}

TEST(ElephantFoot, FollowsTheOutlines) {
  std::mt19937 random(33);
  for (int trial = 0; trial < 100; ++trial) {
    const MultiPolygon outlines = RandomIsland(random, {}, 8);
    const MultiPolygon foot = Foot(outlines);
    EXPECT_EQ(Foot(outlines), foot);
    const double near = 0.01 + 2e-3 * Mm2(foot);
    EXPECT_NEAR(Mm2(Foot(QuarterTurned(outlines))), Mm2(foot), near) << trial;
    EXPECT_NEAR(Mm2(Foot(Mirrored(outlines))), Mm2(foot), near) << trial;
    const MultiPolygon apart = Union(outlines, Moved(outlines, {50'000'000, 0}));
    EXPECT_NEAR(Mm2(Foot(apart)), 2 * Mm2(foot), 1e-3) << trial;
  }
}

}  // namespace
}  // namespace slicefarm::slicing::elephant_foot_test
