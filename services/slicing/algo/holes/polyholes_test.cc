#include "services/slicing/algo/holes/polyholes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::polyholes_test {
namespace {

/// Returns a clockwise polygon on a circle, with equal edges.
Polygon RoundHole(double x_mm, double y_mm, double radius_mm, int corners = 40) {
  Polygon hole;
  for (int i = 0; i < corners; ++i) {
    const double angle = -2 * std::numbers::pi * i / corners;
    hole.push_back(
        {FromMm(x_mm + radius_mm * std::cos(angle)), FromMm(y_mm + radius_mm * std::sin(angle))});
  }
  return hole;
}

ObjectSection Plate(int32_t layer, std::vector<Polygon> holes) {
  ObjectSection section;
  section.layer = layer;
  Region region;
  region.outlines = MakePolygonsOrDie("(-20 -20, 20 -20, 20 20, -20 20)");
  region.outlines[0].holes = std::move(holes);
  section.regions.push_back(std::move(region));
  return section;
}

std::vector<ObjectSection> Made(std::vector<ObjectSection> sections,
                                const PolyholeOptions& options = {.on = true}) {
  std::vector<ObjectSection*> all;
  for (ObjectSection& section : sections) all.push_back(&section);
  MakePolyholes(options, all);
  return sections;
}

const Polygon& HoleOf(const ObjectSection& section) {
  return section.regions[0].outlines[0].holes.at(0);
}

TEST(CircleOf, KnowsRoundHoles) {
  const auto circle = CircleOf(RoundHole(3, 4, 2), {});
  ASSERT_TRUE(circle.has_value());
  EXPECT_NEAR(circle->center.x, 3e6, 5);
  EXPECT_NEAR(circle->center.y, 4e6, 5);
  EXPECT_NEAR(circle->radius_nm, 2e6, 5);
  const PolyholeOptions options;
  EXPECT_FALSE(CircleOf(RoundHole(0, 0, 2, 8), options).has_value());  // an octagon is meant so
  const Polygon square =
      MakePolygonsOrDie(
          "(-9 -9, 9 -9, 9 9, -9 9) (-2 -2, -2 -1, -2 0, -2 2, 0 2, 2 2, 2 0, 2 -2, 1 -2, 0 -2)")[0]
          .holes[0];
  EXPECT_FALSE(CircleOf(square, options).has_value());
  Polygon dented = RoundHole(0, 0, 2);
  dented[7] = {dented[7].x / 2, dented[7].y / 2};
  EXPECT_FALSE(CircleOf(dented, options).has_value());
}

TEST(CircleOf, FollowsTheThreshold) {
  Polygon oval = RoundHole(0, 0, 2);
  for (Point& p : oval) p.x += p.x / 50;  // 0.04 mm wider on each side
  EXPECT_FALSE(CircleOf(oval, {.threshold_nm = 10'000}).has_value());
  EXPECT_TRUE(CircleOf(oval, {.threshold_nm = 100'000}).has_value());
  EXPECT_TRUE(CircleOf(oval, {.threshold_nm = 0, .threshold_share = 0.05}).has_value());
}

// Nophead's rule: two edges per mm of the diameter at a nozzle of 0.4 mm.
TEST(Polyhole, HasEdgesByItsSizeThatTouchTheCircle) {
  for (const double radius_mm : {0.4, 1.0, 2.0, 5.0}) {
    const Polygon hole = Polyhole({{0, 0}, radius_mm * 1e6}, {.twisted = false}, 3);
    EXPECT_EQ(hole.size(), std::max<size_t>(3, std::lround(4 * radius_mm))) << radius_mm;
    EXPECT_LT(SignedArea(hole), 0);
    for (size_t i = 0; i < hole.size(); ++i)
      EXPECT_NEAR(DistanceToSegment({0, 0}, hole[i], hole[(i + 1) % hole.size()]), radius_mm * 1e6,
                  2);
  }
  EXPECT_EQ(Polyhole({{0, 0}, 5e6}, {.max_edges = 8}, 0).size(), 8u);
  EXPECT_EQ(Polyhole({{0, 0}, 5e6}, {.nozzle_nm = 800'000}, 0).size(), 10u);
}

TEST(Polyhole, TwistsOverFiveLayers) {
  const HoleCircle circle{{0, 0}, 2e6};
  const PolyholeOptions twisted{.twisted = true}, plain{.twisted = false};
  EXPECT_EQ(Polyhole(circle, twisted, 2), Polyhole(circle, twisted, 7));
  EXPECT_NE(Polyhole(circle, twisted, 2), Polyhole(circle, twisted, 3));
  EXPECT_EQ(Polyhole(circle, plain, 2), Polyhole(circle, plain, 3));
}

TEST(MakePolyholes, ReplacesHolesOfTwoLayersOrMore) {
  const Polygon hole = RoundHole(1, 2, 2);
  const auto made = Made({Plate(0, {}), Plate(1, {hole}), Plate(2, {hole}), Plate(3, {})});
  EXPECT_EQ(HoleOf(made[1]).size(), 8u);
  EXPECT_EQ(HoleOf(made[2]).size(), 8u);
  EXPECT_NE(HoleOf(made[1]), HoleOf(made[2]));
  // The whole circle remains open.
  EXPECT_GE(-SignedArea(HoleOf(made[1])), -SignedArea(hole));
  const auto single = Made({Plate(0, {}), Plate(1, {hole}), Plate(2, {})});
  EXPECT_EQ(HoleOf(single[1]), hole);
  const auto on_bed = Made({Plate(0, {hole}), Plate(1, {})});
  EXPECT_EQ(HoleOf(on_bed[0]).size(), 8u);
}

// All layers of a hole get the circle of its lowest layer, so that its wall is straight.
TEST(MakePolyholes, GivesAllLayersTheSameCircle) {
  const auto made = Made({Plate(0, {RoundHole(0, 0, 2)}), Plate(1, {RoundHole(0.002, 0, 2.002)})},
                         {.on = true, .twisted = false});
  EXPECT_EQ(HoleOf(made[0]), HoleOf(made[1]));
}

TEST(MakePolyholes, LeavesOtherHolesAndJobsWithoutThemAlone) {
  const Polygon hole = RoundHole(0, 0, 2), octagon = RoundHole(9, 9, 2, 8);
  const auto off = Made({Plate(0, {hole}), Plate(1, {hole})}, {.on = false});
  EXPECT_EQ(HoleOf(off[0]), hole);
  const auto made = Made({Plate(0, {octagon}), Plate(1, {octagon})});
  EXPECT_EQ(HoleOf(made[0]), octagon);
}

}  // namespace
}  // namespace slicefarm::slicing::polyholes_test
