#include "services/motion/algo/toolpath/surface_follower.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::motion::surface_follower_test {
namespace {

constexpr Coord kMm = 1'000'000, kHeight = 200'000, kNozzle = 400'000, kLeast = 50'000;

RegionMotion Contoured() {
  RegionMotion region;
  region.contour_least_nm = kLeast;
  return region;
}

/// Returns a square of 20 mm that rises with x by `rise_nm` per mm, and is at the layer's top at x
/// = 10 mm.
std::vector<SurfaceFacet> Slope(Coord rise_nm) {
  const Coord low = -10 * rise_nm, high = 10 * rise_nm;
  const Point a{0, 0}, b{20 * kMm, 0}, c{20 * kMm, 20 * kMm}, d{0, 20 * kMm};
  return {{{a, b, c}, {low, high, high}}, {{a, c, d}, {low, high, low}}};
}

Path Line(Feature feature, Point from, Point to) {
  Path path;
  path.feature = feature;
  path.points = {from, to};
  path.widths_nm = {450'000};
  return path;
}

std::vector<ContourPoint> Followed(const std::vector<SurfaceFacet>& facets, const Path& path,
                                   const RegionMotion& region = Contoured()) {
  return SurfaceFollower(facets, kHeight, kNozzle).Follow(path, region);
}

TEST(SurfaceFollower, TopLinesFollowTheSlopeWithinTheLayer) {
  // 0.02 mm per mm: the surface enters the layer at x = 0 and leaves it at x = 10 mm.
  const auto facets = Slope(20'000);
  const auto points =
      Followed(facets, Line(Feature::kTopSolidInfill, {0, 5 * kMm}, {20 * kMm, 5 * kMm}));
  ASSERT_GE(points.size(), 4);
  EXPECT_LE(points.size(), 8) << "even slopes need few points";
  for (const ContourPoint& at : points) {
    const double surface = static_cast<double>(at.point.x - 10 * kMm) * 0.02;
    EXPECT_NEAR(static_cast<double>(at.up_nm), std::clamp(surface, -150'000.0, 0.0), 2'100);
    EXPECT_EQ(at.width_nm, 450'000);
  }
  EXPECT_EQ(points.front().point, (Point{0, 5 * kMm}));
  EXPECT_EQ(points.back().point, (Point{20 * kMm, 5 * kMm}));
}

TEST(SurfaceFollower, OtherPathsStayLevel) {
  const auto facets = Slope(10'000);
  const auto follows = [&](Feature feature, const RegionMotion& region = Contoured()) {
    return !Followed(facets, Line(feature, {kMm, 5 * kMm}, {8 * kMm, 5 * kMm}), region).empty();
  };
  for (const Feature feature : {Feature::kTopSolidInfill, Feature::kIroning,
                                Feature::kExternalPerimeter, Feature::kPerimeter})
    EXPECT_TRUE(follows(feature));
  for (const Feature feature :
       {Feature::kSolidInfill, Feature::kInternalInfill, Feature::kBridgeInfill,
        Feature::kOverhangPerimeter, Feature::kGapFill, Feature::kSupportInterface})
    EXPECT_FALSE(follows(feature));
  EXPECT_FALSE(follows(Feature::kTopSolidInfill, RegionMotion())) << "the region is not contoured";
  EXPECT_TRUE(
      Followed(facets, Line(Feature::kTopSolidInfill, {11 * kMm, 0}, {19 * kMm, 0})).empty())
      << "the surface is above the layer";
}

TEST(SurfaceFollower, SteepWallsHaveTheirOuterEdgeAtTheSurface) {
  const auto facets = Slope(100'000);  // 5.7 degrees
  const Path wall = Line(Feature::kExternalPerimeter, {9'500'000, kMm}, {9'500'000, 9 * kMm});
  RegionMotion region = Contoured();
  EXPECT_NEAR(static_cast<double>(Followed(facets, wall, region).front().up_nm), -50'000, 10);
  region.contour_edge_slope_rad = 5 * std::numbers::pi / 180;
  const double edge = -50'000 - 225'000 * std::sin(std::atan(0.1));
  EXPECT_NEAR(static_cast<double>(Followed(facets, wall, region).front().up_nm), edge, 10);
  region.contour_edge_slope_rad = 6 * std::numbers::pi / 180;
  EXPECT_NEAR(static_cast<double>(Followed(facets, wall, region).front().up_nm), -50'000, 10);
  Path fill = wall;
  fill.feature = Feature::kTopSolidInfill;
  region.contour_edge_slope_rad = 0.01;
  EXPECT_NEAR(static_cast<double>(Followed(facets, fill, region).front().up_nm), -50'000, 10);
}

/// Returns the lowest height of the second of two lines beside each other, at x and at x - 0.45 mm.
Coord SecondLine(const std::vector<SurfaceFacet>& facets, Feature first, Coord x) {
  SurfaceFollower follower(facets, kHeight, kNozzle);
  const RegionMotion region = Contoured();
  follower.Follow(Line(first, {x, kMm}, {x, 9 * kMm}), region);
  const auto second = follower.Follow(
      Line(Feature::kTopSolidInfill, {x - 450'000, kMm}, {x - 450'000, 9 * kMm}), region);
  Coord lowest = 0;
  for (const ContourPoint& at : second) lowest = std::min(lowest, at.up_nm);
  return lowest;
}

TEST(SurfaceFollower, NeverDipsFarBelowPrintedBeads) {
  const auto facets = Slope(100'000);
  EXPECT_NEAR(static_cast<double>(SecondLine(facets, Feature::kTopSolidInfill, 9'500'000)), -95'000,
              10)
      << "0.045 mm below its neighbour";
  EXPECT_EQ(SecondLine(facets, Feature::kSolidInfill, 9'500'000), -50'000)
      << "a level line beside it";
  EXPECT_NEAR(static_cast<double>(SecondLine(Slope(200'000), Feature::kTopSolidInfill, 9'900'000)),
              -70'000, 10)
      << "0.05 mm below a neighbour at -0.02 mm";
}

TEST(SurfaceFollower, GoesDownAlongItsOwnLine) {
  const auto facets = Slope(200'000);
  const auto points =
      Followed(facets, Line(Feature::kTopSolidInfill, {10 * kMm, kMm}, {9'200'000, kMm}));
  EXPECT_NEAR(static_cast<double>(points.back().up_nm), -150'000, 10);
}

}  // namespace
}  // namespace slicefarm::motion::surface_follower_test
