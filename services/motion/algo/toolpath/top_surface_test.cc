#include "services/motion/algo/toolpath/top_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
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

/// Returns level facets that cover half of a square of 4 m, the i-th at the height -`step_nm` * i.
std::vector<SurfaceFacet> Stack(size_t count, Coord step_nm) {
  constexpr Coord kFar = 2'000 * kMm;
  std::vector<SurfaceFacet> facets(count);
  for (size_t i = 0; i < count; ++i) {
    const Coord up = -step_nm * static_cast<Coord>(i);
    facets[i] = {{Point{-kFar, -kFar}, {kFar, -kFar}, {-kFar, kFar}}, {up, up, up}};
  }
  return facets;
}

// 16,400 facets, each in 512 x 512 squares, have more than 2^32 places in the squares.
TEST(TopSurface, LargeFacetsTakeLittleMemory) {
  const std::vector<SurfaceFacet> facets = Stack(16'400, 10);
  const TopSurface surface(facets, 1);
  EXPECT_EQ(surface.At({0, 0}, -200'000, 0)->up_nm, 0);
  EXPECT_EQ(surface.At({-2'000 * kMm, 1'900 * kMm}, -200'000, 0)->up_nm, 0);
  EXPECT_FALSE(surface.At({1'000 * kMm, 1'000 * kMm}, -200'000, 0));
}

// A search through all facets would need 10^11 steps.
TEST(TopSurface, LevelFacetsAboveEachOtherAreNotSearched) {
  std::vector<SurfaceFacet> facets = Stack(1'000'000, 1);
  std::ranges::reverse(facets);
  const TopSurface surface(facets, 2 * kMm);
  for (Coord i = 0; i < 100'000; ++i)
    ASSERT_EQ(surface.At({-i * 10'000, -i}, -200'000, 0)->up_nm, 0);
}

TEST(TopSurface, NeedlesAndFacetsWithoutAreaAreNothing) {
  constexpr Coord kFar = 2'000 * kMm;
  const std::vector<SurfaceFacet> facets = {
      {{Point{-kFar, -kFar}, {kFar, kFar}, {0, 0}}, {}},
      {{Point{5, 5}, {5, 5}, {5, 5}}, {}},
      {{Point{-kFar, -kFar}, {kFar, kFar}, {kFar - 1, kFar}}, {-10, -10, -10}}};
  const TopSurface surface(facets, 1);
  EXPECT_EQ(surface.At({kFar, kFar}, -200'000, 0)->up_nm, -10);
  EXPECT_FALSE(surface.At({1, 0}, -200'000, 0));
  const TopSurface none({facets.data(), 2}, 1);
  EXPECT_FALSE(none.At({0, 0}, -200'000, 0));
  EXPECT_FALSE(none.IsNear({0, 0}));
}

}  // namespace
}  // namespace slicefarm::motion::top_surface_test
