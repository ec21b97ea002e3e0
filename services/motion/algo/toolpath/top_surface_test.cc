#include "services/motion/algo/toolpath/top_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::motion::top_surface_test {
namespace {

constexpr Coord kMm = 1'000'000;

/// Returns the two facets of a square of 20 mm that rises with x: from -0.2 mm to 0 mm.
std::vector<SurfaceFacet> Slope() {
  const Point a{0, 0}, b{20 * kMm, 0}, c{20 * kMm, 20 * kMm}, d{0, 20 * kMm};
  return {{{a, b, c}, {-200'000, 0, 0}}, {{a, c, d}, {-200'000, 0, -200'000}}};
}

TEST(TopSurface, HasTheHeightAndSlopeOfItsFacets) {
  const std::vector<SurfaceFacet> facets = Slope();
  const TopSurface surface(facets, 2 * kMm);
  for (const Coord x : {Coord{0}, 5 * kMm, 13 * kMm, 20 * kMm}) {
    for (const Coord y : {Coord{0}, 7 * kMm, 13 * kMm, 20 * kMm}) {
      const auto place = surface.At({x, y}, -200'000, 0);
      ASSERT_TRUE(place) << x << " " << y;
      EXPECT_NEAR(place->up_nm, -200'000 + static_cast<double>(x) / 100, 1e-3);
      EXPECT_NEAR(place->slope_rad, std::atan(0.01), 1e-9);
    }
  }
}

TEST(TopSurface, IsNothingOutsideTheFacetsAndTheHeights) {
  const std::vector<SurfaceFacet> facets = Slope();
  const TopSurface surface(facets, 2 * kMm);
  EXPECT_FALSE(surface.At({-1, 5 * kMm}, -200'000, 0));
  EXPECT_FALSE(surface.At({5 * kMm, 20 * kMm + 1}, -200'000, 0));
  EXPECT_FALSE(surface.At({5 * kMm, 5 * kMm}, -100'000, 0)) << "lower";
  EXPECT_FALSE(surface.At({15 * kMm, 5 * kMm}, -200'000, -100'000)) << "higher";
  EXPECT_FALSE(TopSurface({}, kMm).At({0, 0}, -200'000, 0));
}

TEST(TopSurface, TheHighestPlaceCounts) {
  std::vector<SurfaceFacet> facets = Slope();
  facets.push_back(
      {{Point{0, 0}, {20 * kMm, 0}, {20 * kMm, 20 * kMm}}, {-10'000, -10'000, -10'000}});
  const TopSurface surface(facets, 2 * kMm);
  EXPECT_NEAR(surface.At({10 * kMm, kMm}, -200'000, 0)->up_nm, -10'000, 1e-3);
  EXPECT_NEAR(surface.At({10 * kMm, kMm}, -200'000, -20'000)->up_nm, -100'000, 1e-3);
}

TEST(TopSurface, SlopesDownwardsInAnyDirection) {
  for (const double turn : {0.0, 1.0, 2.5, 4.0}) {
    const auto corner = [&](double angle) {
      return Point{std::llround(5e6 * std::cos(angle)), std::llround(5e6 * std::sin(angle))};
    };
    const std::array<Point, 3> corners = {corner(turn), corner(turn + 2), corner(turn + 4)};
    SurfaceFacet facet{corners, {}};
    for (size_t i = 0; i < 3; ++i) facet.up_nm[i] = -1'000'000 + (corners[i].x + corners[i].y) / 10;
    const TopSurface surface({&facet, 1}, kMm);
    const auto place = surface.At({0, 0}, -2'000'000, 0);
    ASSERT_TRUE(place);
    EXPECT_NEAR(place->up_nm, -1'000'000, 2);
    EXPECT_NEAR(place->slope_rad, std::atan(0.1 * std::numbers::sqrt2), 1e-6);
  }
}

TEST(TopSurface, KnowsWhatIsNear) {
  const std::vector<SurfaceFacet> facets = Slope();
  const TopSurface surface(facets, 2 * kMm);
  for (const Point inside : {Point{-2 * kMm, 0}, Point{10 * kMm, 22 * kMm}, Point{kMm, kMm}})
    EXPECT_TRUE(surface.IsNear(inside));
  for (const Point outside : {Point{-5 * kMm, 0}, Point{10 * kMm, 30 * kMm}})
    EXPECT_FALSE(surface.IsNear(outside));
}

}  // namespace
}  // namespace slicefarm::motion::top_surface_test
