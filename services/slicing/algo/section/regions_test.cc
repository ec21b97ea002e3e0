#include "services/slicing/algo/section/regions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/predicates.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::regions_test {
namespace {

constexpr Coord kMm = kNmPerMm;

Polygon Square(double x, double y, double size) {
  const Coord x0 = FromMm(x), y0 = FromMm(y), x1 = FromMm(x + size), y1 = FromMm(y + size);
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
Polygon Clockwise(Polygon ring) { return {ring.rbegin(), ring.rend()}; }

double AreaMm2(const MultiPolygon& region) { return Area(region) * 1e-12; }

struct Case {
  std::string name;
  std::vector<Polygon> loops;
  double non_zero, even_odd, positive;
};

TEST(RegionOf, FollowsTheFillRule) {
  const std::vector<Case> cases = {
      {"None", {}, 0, 0, 0},
      {"One", {Square(0, 0, 10)}, 100, 100, 100},
      {"Overlapping", {Square(0, 0, 10), Square(5, 5, 10)}, 175, 150, 175},
      {"Inverted", {Clockwise(Square(0, 0, 10))}, 100, 100, 0},
      {"NestedShell", {Square(0, 0, 10), Clockwise(Square(2, 2, 5))}, 75, 75, 75},
      {"NestedSameWay", {Square(0, 0, 10), Square(2, 2, 5)}, 100, 75, 100},
      {"TheSameTwice", {Square(0, 0, 10), Square(0, 0, 10)}, 100, 0, 100},
      {"TouchingSides", {Square(0, 0, 10), Square(10, 0, 10)}, 200, 200, 200},
      {"TouchingCorners", {Square(0, 0, 10), Square(10, 10, 10)}, 200, 200, 200},
  };
  for (const Case& c : cases) {
    EXPECT_NEAR(AreaMm2(RegionOf(c.loops, FillRule::kNonZero, 0)), c.non_zero, 1e-9) << c.name;
    EXPECT_NEAR(AreaMm2(RegionOf(c.loops, FillRule::kEvenOdd, 0)), c.even_odd, 1e-9) << c.name;
    EXPECT_NEAR(AreaMm2(RegionOf(c.loops, FillRule::kPositive, 0)), c.positive, 1e-9) << c.name;
  }
}

/// Returns a circle of n points with a ripple below the resolution.
Polygon Ripple(double radius_mm, int n, Coord ripple_nm) {
  Polygon ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979 * i / n;
    const double r = radius_mm * 1e6 + static_cast<double>(i % 2 ? ripple_nm : -ripple_nm);
    ring.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))});
  }
  return ring;
}

void ExpectTrueCorners(const Polygon& ring, bool counter_clockwise) {
  ASSERT_GE(ring.size(), 3u);
  EXPECT_EQ(SignedArea(ring) > 0, counter_clockwise);
  for (size_t i = 0; i < ring.size(); ++i)
    EXPECT_NE(Orientation(ring[i], ring[(i + 1) % ring.size()], ring[(i + 2) % ring.size()]), 0);
}

TEST(RegionOf, SimplifiesWithinTheResolution) {
  const std::vector<Polygon> loops = {Ripple(20, 5'000, 1'000),
                                      Clockwise(Ripple(15, 5'000, 1'000))};
  const MultiPolygon region = RegionOf(loops, FillRule::kNonZero, 5'000);
  ASSERT_EQ(region.size(), 1u);
  EXPECT_LT(PointCount(region), 500u);
  EXPECT_NEAR(AreaMm2(region), 3.14159265 * (400 - 225), 0.5);
  ExpectTrueCorners(region[0].outer, true);
  ASSERT_EQ(region[0].holes.size(), 1u);
  ExpectTrueCorners(region[0].holes[0], false);
  MultiPolygon canonical = region;
  Canonicalize(canonical);
  EXPECT_EQ(region, canonical);
}

TEST(RegionOf, ScrapsVanish) {
  const std::vector<Polygon> loops = {{{0, 0}, {4'000, 0}, {0, 4'000}}, {{0, 0}, {9, 9}}, {}};
  EXPECT_TRUE(RegionOf(loops, FillRule::kNonZero, 5'000).empty());
}

TEST(EditsFor, NamesWhatEachSettingDoes) {
  ObjectSlicingOptions options;
  options.closing_radius_nm = 49'000;
  options.xy_compensation_nm = 100'000;
  options.hole_compensation_nm = 20'000;
  options.elephant_foot_nm = 150'000;
  options.elephant_foot_min_width_nm = 757'000;
  EXPECT_EQ(EditsFor(0, true, options), (RegionEdits{0, 100'000, 150'000, 757'000, 20'000}));
  EXPECT_EQ(EditsFor(1, true, options), (RegionEdits{0, 100'000, 0, 0, 20'000}));
  EXPECT_EQ(EditsFor(1, false, options), (RegionEdits{49'000, 100'000, 0, 0, 20'000}));
  options.elephant_foot_nm = -150'000;
  EXPECT_EQ(EditsFor(0, true, options), (RegionEdits{0, 250'000, 0, 0, 20'000}));
}

const MultiPolygon& Frame() {
  static const auto* frame = new MultiPolygon(
      RegionOf({Square(0, 0, 20), Clockwise(Square(5, 5, 10))}, FillRule::kNonZero, 0));
  return *frame;
}

TEST(Edited, GrowsOutlinesAndShrinksHoles) {
  EXPECT_NEAR(AreaMm2(Edited(Frame(), {.grow_nm = kMm}, 0)), 22 * 22 - 8 * 8, 1e-6);
  EXPECT_NEAR(AreaMm2(Edited(Frame(), {.grow_nm = -kMm}, 0)), 18 * 18 - 12 * 12, 1e-6);
}

TEST(Edited, TheFootIsTakenOffWhereTheMaterialIsWide) {
  EXPECT_NEAR(AreaMm2(Edited(Frame(), {.foot_nm = kMm / 5, .foot_min_width_nm = kMm}, 0)),
              19.6 * 19.6 - 10.4 * 10.4, 0.05);
  const MultiPolygon bar = {{{{0, 0}, {20 * kMm, 0}, {20 * kMm, 5 * kMm}, {0, 5 * kMm}}, {}}};
  EXPECT_NEAR(AreaMm2(Edited(bar, {.foot_nm = kMm / 5, .foot_min_width_nm = 4'900'000}, 0)),
              19.9 * 4.9, 0.01);
  EXPECT_NEAR(AreaMm2(Edited(Frame(), {.grow_nm = kMm, .foot_nm = kMm / 5}, 0)),
              21.6 * 21.6 - 8.4 * 8.4, 0.05);
}

TEST(Edited, WidensOrNarrowsHolesOnly) {
  EXPECT_NEAR(AreaMm2(Edited(Frame(), {.widen_holes_nm = kMm}, 0)), 400 - 144, 1e-6);
  EXPECT_NEAR(AreaMm2(Edited(Frame(), {.widen_holes_nm = -kMm}, 0)), 400 - 64, 1e-6);
  EXPECT_NEAR(AreaMm2(Edited(Frame(), {.widen_holes_nm = 6 * kMm}, 0)), 0, 1e-6);
  EXPECT_NEAR(AreaMm2(Edited(Frame(), {.widen_holes_nm = -6 * kMm}, 0)), 400, 1e-6);
}

TEST(Edited, AnIslandInAHoleIsKeptWhenTheHoleClosesOverIt) {
  const MultiPolygon nested = RegionOf(
      {Square(0, 0, 20), Clockwise(Square(5, 5, 10)), Square(8, 8, 4)}, FillRule::kNonZero, 0);
  ASSERT_EQ(nested.size(), 2u);
  EXPECT_NEAR(AreaMm2(Edited(nested, {.widen_holes_nm = kMm}, 0)), 400 - 144 + 16, 1e-6);
  EXPECT_NEAR(AreaMm2(Edited(nested, {.widen_holes_nm = -4 * kMm}, 0)), 400, 1e-6);
}

TEST(Edited, ClosesNarrowCracksOnly) {
  // Two squares are 0.09 mm apart, and two are 0.2 mm apart.
  const MultiPolygon region =
      RegionOf({Square(0, 0, 10), Square(10.09, 0, 10), Square(0, 20, 10), Square(10.2, 20, 10)},
               FillRule::kNonZero, 0);
  ASSERT_EQ(region.size(), 4u);
  const MultiPolygon closed = Edited(region, {.closing_radius_nm = 49'000}, 0);
  EXPECT_EQ(closed.size(), 3u);
  EXPECT_NEAR(AreaMm2(closed), 400 + 0.9, 0.01);
}

TEST(Edited, NothingToDoIsNothingDone) {
  EXPECT_EQ(Edited(Frame(), {}, 5'000), Frame());
  EXPECT_TRUE(Edited({}, {.grow_nm = kMm}, 0).empty());
}

TEST(EditsFor, TheFootFadesOutOverItsLayers) {
  ObjectSlicingOptions options;
  options.elephant_foot_nm = 160'000;
  options.elephant_foot_layers = 4;
  const auto foot = [&](int32_t layer) { return EditsFor(layer, true, options).foot_nm; };
  EXPECT_EQ(foot(0), 160'000);
  EXPECT_EQ(foot(1), 120'000);
  EXPECT_EQ(foot(3), 40'000);
  EXPECT_EQ(foot(4), 0);
  options.elephant_foot_nm = -160'000;
  EXPECT_EQ(EditsFor(1, true, options).grow_nm, 0) << "growth is for the first layer alone";
}

}  // namespace
}  // namespace slicefarm::slicing::regions_test
