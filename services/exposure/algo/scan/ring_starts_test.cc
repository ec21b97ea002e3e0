#include "services/exposure/algo/scan/ring_starts.h"

#include <gtest/gtest.h>

#include <random>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "services/exposure/algo/scan/convex_rings.h"

namespace slicefarm::exposure::ring_starts_test {
namespace {

Polyline Square(Coord half) {
  return {{-half, -half}, {half, -half}, {half, half}, {-half, half}, {-half, -half}};
}

TEST(StartAtShare, OnOneWayThroughTheMiddle) {
  std::vector<Polyline> rings = {Square(300), Square(200), Square(100)};
  StartAtShare(rings, 0.125);  // half of the lower side
  EXPECT_EQ(rings[0].front(), (Point{0, -300}));
  EXPECT_EQ(rings[1].front(), (Point{0, -200}));
  EXPECT_EQ(rings[2].front(), (Point{0, -100}));
  for (const Polyline& ring : rings) {
    EXPECT_EQ(ring.size(), 6u);
    EXPECT_EQ(ring.front(), ring.back());
    EXPECT_DOUBLE_EQ(SignedArea({ring.begin(), ring.end() - 1}),
                     4.0 * static_cast<double>(ring[0].y) * static_cast<double>(ring[0].y));
  }
}

TEST(StartAtShare, ACornerIsNotDoubled) {
  std::vector<Polyline> rings = {Square(300)};
  StartAtShare(rings, 0.5);
  EXPECT_EQ(rings[0], (Polyline{{300, 300}, {-300, 300}, {-300, -300}, {300, -300}, {300, 300}}));
}

TEST(StartAtShare, NeverOnASpur) {
  // A long spur from the first corner: it does not count in the share of the length.
  const Polyline spurred = {{0, 0}, {100, 0}, {100, 100}, {900, 900}, {100, 100}, {0, 100}, {0, 0}};
  for (double share = 0; share < 1; share += 0.05) {
    std::vector<Polyline> rings = {spurred};
    StartAtShare(rings, share);
    EXPECT_LE(rings[0].front().x, 100);
    EXPECT_EQ(std::ranges::count(rings[0], Point{900, 900}), 1);
  }
}

TEST(StartAtShare, TowardsALineInTheMiddle) {
  std::vector<Polyline> rings = {{{0, 0}, {1000, 0}, {1000, 200}, {0, 200}, {0, 0}},
                                 {{100, 100}, {900, 100}}};
  StartAtShare(rings, 0.25);
  EXPECT_EQ(rings[0].front(), (Point{600, 0}));
  EXPECT_EQ(rings[1], (Polyline{{100, 100}, {900, 100}}));
}

TEST(StartAtShare, LinksAreShort) {
  std::mt19937 random(9);
  for (int i = 0; i < 300; ++i) {
    const Polygon hull = ConvexHull(RandomStar(random, 3, Uniform(random, 0.1, 1)));
    if (hull.size() < 3) continue;
    auto rings = ConvexRings(hull, 1, {.pitch_nm = 80'000, .first_nm = 40'000});
    const auto before = rings;
    StartAtShare(rings, Uniform(random, 0, 1));
    double links = 0;
    for (size_t k = 0; k < rings.size(); ++k) {
      EXPECT_NEAR(Length(rings[k]), Length(before[k]), 10);
      if (k > 0 && rings[k].size() > 3) links += Distance(rings[k - 1][0], rings[k][0]);
    }
    // All links are on one straight line.
    EXPECT_LE(links, 3.1e6);
  }
}

}  // namespace
}  // namespace slicefarm::exposure::ring_starts_test
