#include "common/geometry/offset/offset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::offset_test {
namespace {

double OffsetAreaMm2(const MultiPolygon& polygons) { return Area(polygons) / 1e12; }

const MultiPolygon kUnitSquare = MakePolygonsOrDie("(0 0, 1 0, 1 1, 0 1)");

// errata 10.1.1: round joins at 0.1.
TEST(Offset, RoundJoinsGiveTheMinkowskiSum) {
  const MultiPolygon grown =
      Offset(kUnitSquare, FromMm(0.1), {.join = Join::kRound, .arc_tolerance_nm = 10});
  EXPECT_NEAR(OffsetAreaMm2(grown), 1.4314159, 1e-5);
  EXPECT_NEAR(Perimeter(grown[0].outer) / 1e6, 4.6283185, 1e-4);
}

struct MiterCase {
  double degrees;
  double factor;
};

class MiterTest : public testing::TestWithParam<MiterCase> {};

// errata 10.1.2: the miter of a corner of the angle theta is 1 / sin(theta / 2) offsets long.
TEST_P(MiterTest, IsAsLongAsTheAngleAsks) {
  const auto [degrees, factor] = GetParam();
  const double angle = degrees * std::numbers::pi / 180;
  const Polygon corner = {
      {0, 0}, {FromMm(100), 0}, {FromMm(100 * std::cos(angle)), FromMm(100 * std::sin(angle))}};
  const MultiPolygon grown = Offset({{corner, {}}}, FromMm(1), {.miter_limit = 20});
  double reach = 0;  // distance of the tip at the origin's corner
  for (const Point p : grown[0].outer)
    if (Norm(p) < 10e6) reach = std::max(reach, Norm(p));
  EXPECT_NEAR(reach / 1e6, factor, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Angles, MiterTest,
                         testing::Values(MiterCase{30, 3.8637033}, MiterCase{60, 2},
                                         MiterCase{90, 1.4142136}, MiterCase{120, 1.1547005}));

class NotchTest : public testing::TestWithParam<MiterCase> {};

// errata 10.1.2: the rule for an inward offset at a reflex corner: 1 / |sin(theta / 2)|.
TEST_P(NotchTest, InwardMiterIsAsLongAsTheAngleAsks) {
  const auto [degrees, factor] = GetParam();
  // Half of the notch's opening angle.
  const double half = (360 - degrees) / 2 * std::numbers::pi / 180;
  const double deep = 300, wide = deep * std::tan(half);
  // A wide plate with a notch from above. The tip of the notch is at the origin.
  const Polygon plate = {{FromMm(-wide - 400), FromMm(-400)},
                         {FromMm(wide + 400), FromMm(-400)},
                         {FromMm(wide + 400), FromMm(deep)},
                         {FromMm(wide), FromMm(deep)},
                         {0, 0},
                         {FromMm(-wide), FromMm(deep)},
                         {FromMm(-wide - 400), FromMm(deep)}};
  const MultiPolygon inset = Offset({{plate, {}}}, -FromMm(1), {.miter_limit = 200});
  double lowest = 0;
  for (const Point p : inset[0].outer)
    if (std::abs(p.x) < FromMm(0.01)) lowest = std::min(lowest, static_cast<double>(p.y));
  EXPECT_NEAR(-lowest / 1e6, factor, factor * 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Angles, NotchTest,
                         testing::Values(MiterCase{240, 1.1547005}, MiterCase{300, 2},
                                         MiterCase{359, 114.593}));

// errata 10.1.2: a miter limit m keeps corners down to 2 asin(1 / m).
TEST(Offset, MiterLimitIsAnAngle) {
  const auto reach = [](double degrees, double limit) {
    const double angle = degrees * std::numbers::pi / 180;
    const Polygon corner = {
        {0, 0}, {FromMm(100), 0}, {FromMm(100 * std::cos(angle)), FromMm(100 * std::sin(angle))}};
    const MultiPolygon grown = Offset({{corner, {}}}, FromMm(1), {.miter_limit = limit});
    double far = 0;
    for (const Point p : grown[0].outer)
      if (Norm(p) < 10e6) far = std::max(far, Norm(p));
    return far / 1e6;
  };
  EXPECT_NEAR(reach(60.1, 2), 1 / std::sin(60.1 * std::numbers::pi / 360), 1e-4);
  EXPECT_LT(reach(59.9, 2), 1.9);
  EXPECT_NEAR(reach(28.97, 4), 1 / std::sin(28.97 * std::numbers::pi / 360), 1e-4);
  EXPECT_LT(reach(28.94, 4), 3.9);
}

// errata 10.1.2: an arc of radius d within the tolerance has pi / acos(1 - tolerance / d) steps per
// turn, which is 49.66 for 5 mm and 0.01 mm. The arc covers the turn between the edges, not the
// rest of the circle.
TEST(Offset, RoundJoinsTakeTheStepsTheToleranceAsks) {
  const Polygon dot = {{0, 0}, {1'000, 0}, {1'000, 1'000}, {0, 1'000}};
  const MultiPolygon disc =
      Offset({{dot, {}}}, FromMm(5), {.join = Join::kRound, .arc_tolerance_nm = FromMm(0.01)});
  EXPECT_GE(disc[0].outer.size(), 49u);
  EXPECT_LE(disc[0].outer.size(), 58u);  // rounded up at each of four corners
  // Edges at 170 and at -170 degrees: the arc between them covers 20 degrees, not 340.
  const double a = 20 * std::numbers::pi / 180;
  const Polygon bend = {{FromMm(50), FromMm(-50)},
                        {FromMm(50), FromMm(50)},
                        {FromMm(50 - 100 * std::sin(a)), FromMm(50 + 100 * std::cos(a))},
                        {FromMm(-100), FromMm(-50)}};
  const MultiPolygon sharp = Offset({{bend, {}}}, FromMm(5));
  const MultiPolygon round = Offset({{bend, {}}}, FromMm(5), {.join = Join::kRound});
  EXPECT_LT(Area(round), Area(sharp));
  EXPECT_GT(Area(round), Area({bend, {}}));
}

TEST(Offset, LongMitersAreCutAtTheLimit) {
  const Polygon sharp = MakeLineOrDie("(0 0, 100 -1, 100 1)");
  const MultiPolygon limited = Offset({{sharp, {}}}, FromMm(1), {.miter_limit = 2});
  EXPECT_GT(Bounds(limited).min.x, FromMm(-2.1));
  const MultiPolygon unlimited = Offset({{sharp, {}}}, FromMm(1), {.miter_limit = 200});
  EXPECT_LT(Bounds(unlimited).min.x, FromMm(-90));
}

TEST(Offset, MiterAtNinetyDegreesIsASquare) {
  EXPECT_NEAR(OffsetAreaMm2(Offset(kUnitSquare, FromMm(0.1))), 1.44, 1e-9);
  EXPECT_NEAR(OffsetAreaMm2(Offset(kUnitSquare, FromMm(0.1), {.join = Join::kSquare})),
              1.44 - 4 * 0.01 * (std::sqrt(2) - 1) * (std::sqrt(2) - 1), 1e-6);
}

// errata 10.1.2: adjacent offset lines of a ring that shrinks too far meet again on the far side.
TEST(Offset, OverShrunkRingsVanish) {
  EXPECT_TRUE(Offset(kUnitSquare, -FromMm(0.6)).empty());
  EXPECT_TRUE(Offset(kUnitSquare, -FromMm(0.5)).empty());
  EXPECT_FALSE(Offset(kUnitSquare, -FromMm(0.499)).empty());
  EXPECT_TRUE(Offset(MakePolygonsOrDie("(0 0, 4 0, 4 1, 0 1)"), -FromMm(0.6)).empty());
}

// errata, exercise 10.1.
TEST(Offset, ExerciseTriangleInset) {
  const MultiPolygon inset = Offset(MakePolygonsOrDie("(0 0, 4 0, 2 3)"), -FromMm(0.5));
  ASSERT_EQ(inset.size(), 1u);
  const Polygon& ring = inset[0].outer;
  ASSERT_EQ(ring.size(), 3u);
  EXPECT_NEAR(OffsetAreaMm2(inset), 1.70370727, 1e-5);
  EXPECT_NEAR(ToMm(ring[0].x), .93425855, 2e-6);
  EXPECT_NEAR(ToMm(ring[0].y), .5, 2e-6);
  EXPECT_NEAR(ToMm(ring[1].x), 3.06574145, 2e-6);
  EXPECT_NEAR(ToMm(ring[2].x), 2, 2e-6);
  EXPECT_NEAR(ToMm(ring[2].y), 2.09861218, 2e-6);
}

TEST(Offset, HolesShrinkAsThePartGrows) {
  const MultiPolygon frame = MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) (3 3, 6 3, 6 6, 3 6)");
  EXPECT_NEAR(OffsetAreaMm2(Offset(frame, FromMm(1))), 121 - 1, 1e-9);
  EXPECT_NEAR(OffsetAreaMm2(Offset(frame, FromMm(2))), 169, 1e-9);
  EXPECT_NEAR(OffsetAreaMm2(Offset(frame, -FromMm(1))), 49 - 25, 1e-9);
}

TEST(Offset, ZeroAndEmptyAreUnchanged) {
  EXPECT_EQ(Offset(kUnitSquare, 0), kUnitSquare);
  EXPECT_TRUE(Offset({}, FromMm(1)).empty());
}

TEST(OffsetTwice, OpeningDropsWhatIsNarrow) {
  const MultiPolygon lollipop =
      MakePolygonsOrDie("(0 0, 4 0, 4 1.9, 9 1.9, 9 2.1, 4 2.1, 4 4, 0 4)");
  EXPECT_NEAR(OffsetAreaMm2(OffsetTwice(lollipop, -FromMm(0.2), FromMm(0.2))), 16, 1e-6);
}

TEST(OffsetLines, CapsDecideTheEnds) {
  const std::vector<Polyline> line = {MakeLineOrDie("(0 0, 10 0)")};
  EXPECT_NEAR(OffsetAreaMm2(OffsetLines(line, FromMm(1), Cap::kButt)), 20, 1e-6);
  EXPECT_NEAR(OffsetAreaMm2(OffsetLines(line, FromMm(1), Cap::kSquare)), 24, 1e-6);
  EXPECT_NEAR(OffsetAreaMm2(OffsetLines(line, FromMm(1), Cap::kRound)), 20 + std::numbers::pi,
              0.02);
}

// If the input is turned by 90 degrees, mirrored or moved, the result is turned, mirrored or moved
// in the same manner.
TEST(Offset, CommutesWithRigidMotions) {
  const MultiPolygon shape = MakePolygonsOrDie("(0 0, 9 0, 9 3, 5 3, 5 7, 0 9) (1 1, 2 1, 2 2)");
  const double area = Area(Offset(shape, -FromMm(0.3)));
  const auto mapped = [&](auto&& map) {
    MultiPolygon moved = shape;
    for (Polygon* ring : {&moved[0].outer, &moved[0].holes[0]})
      for (Point& p : *ring) p = map(p);
    if (SignedArea(moved[0].outer) < 0) {
      std::reverse(moved[0].outer.begin(), moved[0].outer.end());
      std::reverse(moved[0].holes[0].begin(), moved[0].holes[0].end());
    }
    return Area(Offset(moved, -FromMm(0.3)));
  };
  const double tolerance = 40e6;  // nm^2: one nm of rounding along the perimeter
  EXPECT_NEAR(mapped([](Point p) { return Point{-p.y, p.x}; }), area, tolerance);
  EXPECT_NEAR(mapped([](Point p) { return Point{-p.x, p.y}; }), area, tolerance);
  EXPECT_NEAR(mapped([](Point p) {
                return p + Point{123'456'789, -987'654'321};
              }),
              area, tolerance);
}

}  // namespace
}  // namespace slicefarm::offset_test
