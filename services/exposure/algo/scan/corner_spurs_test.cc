#include "services/exposure/algo/scan/corner_spurs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::corner_spurs_test {
namespace {

const SpurFill kSpot = {.spot_nm = 100, .least_nm = 0};

/// Returns the points that are not corners of the ring.
ConvexRing TipsOf(const ConvexRing& spurred) {
  ConvexRing tips;
  for (size_t i = 1; i + 1 < spurred.size() + 1; ++i) {
    const Vector2 before = spurred[i - 1], after = spurred[(i + 1) % spurred.size()];
    if (before.x() == after.x() && before.y() == after.y()) tips.push_back(spurred[i]);
  }
  return tips;
}

TEST(WithSpurs, TheSpotTouchesTheTipOfARightAngle) {
  const ConvexRing ring = {{50, 50}, {950, 50}, {950, 950}, {50, 950}};
  const ConvexRing around = {{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
  const ConvexRing tips = TipsOf(WithSpurs(ring, around, kSpot));
  ASSERT_EQ(tips.size(), 4u);
  for (const Vector2& tip : tips) {
    const double dx = std::min(tip.x(), 1000 - tip.x()), dy = std::min(tip.y(), 1000 - tip.y());
    EXPECT_NEAR(std::hypot(dx, dy), 50, 1e-9);
    EXPECT_NEAR(dx, dy, 1e-9);
  }
}

TEST(WithSpurs, BluntCornersHaveNone) {
  ConvexRing ring, around;
  for (int i = 0; i < 8; ++i) {
    const double t = i * std::acos(-1.0) / 4;
    ring.push_back({900 * std::cos(t), 900 * std::sin(t)});
    around.push_back({950 * std::cos(t), 950 * std::sin(t)});
  }
  EXPECT_EQ(WithSpurs(ring, around, kSpot).size(), 8u);
}

TEST(WithSpurs, ShortOnesAreLeftOut) {
  const ConvexRing ring = {{50, 50}, {950, 50}, {950, 950}, {50, 950}};
  const ConvexRing around = {{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
  EXPECT_EQ(WithSpurs(ring, around, {.spot_nm = 100, .least_nm = 30}).size(), 4u);
}

TEST(WithSpurs, AnEndOfTheGapThatIsNoTipIsReached) {
  // A tapering strip: the ring ends where the strip is two gaps wide, the gap continues to the
  // left.
  const ConvexRing around = {{0, -45}, {1000, -60}, {1000, 60}, {0, 45}};
  const ConvexRing ring = {{333, 0}, {950, -9}, {950, 9}};
  const ConvexRing spurred = WithSpurs(ring, around, kSpot);
  double left = 1000;
  for (const Vector2& p : spurred) left = std::min(left, p.x());
  EXPECT_NEAR(left, 50, 1);
}

BorderGrid BorderOf(const MultiPolygon& region) { return {region, SpurReach(1e6)}; }

/// An L-shaped region, with a lower piece made by a cut along y = 10.
constexpr char kL[] = "(0 0, 20 0, 20 10, 10 10, 10 20, 0 20)";

TEST(WithOuterSpurs, OnlyIntoCornersThatACutHasMade) {
  const MultiPolygon region = MakePolygonsOrDie(kL);
  const double gap = 1e6;
  const ConvexRing ring = {{1e6, 1e6}, {19e6, 1e6}, {19e6, 9e6}, {1e6, 9e6}};
  const ConvexRing tips = TipsOf(WithOuterSpurs(ring, gap, BorderOf(region), {.spot_nm = 2e6}));
  // The cut is the left half of the upper side. Only its left end is a corner, where the spur
  // follows the border and ends half a gap from the cut.
  ASSERT_EQ(tips.size(), 1u);
  EXPECT_NEAR(tips[0].x(), 1e6, 1);
  EXPECT_NEAR(tips[0].y(), 9.5e6, 1);
}

TEST(WithOuterSpurs, BetweenCutsAlongTheBisectorButNotNearTheBorder) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 100 0, 100 100, 0 100)");
  const double gap = 1e6;
  // The corner at (50, 50) of this piece is deep inside.
  const ConvexRing inner = {{51e6, 51e6}, {60e6, 51e6}, {51e6, 60e6}};
  const ConvexRing tips = TipsOf(WithOuterSpurs(inner, gap, BorderOf(region), {.spot_nm = 2e6}));
  ASSERT_GE(tips.size(), 1u);
  const auto corner = std::min_element(
      tips.begin(), tips.end(), [](Vector2 a, Vector2 b) { return a.x() + a.y() < b.x() + b.y(); });
  EXPECT_NEAR(corner->x(), 50e6 + 1e6 * std::sqrt(0.5), 1);
  EXPECT_NEAR(corner->y(), corner->x(), 1);
  // With the corner on the border, nothing is nearer to the border than the gap.
  const ConvexRing outer = {{51e6, 1.5e6}, {60e6, 8e6}, {42e6, 8e6}};
  for (const Vector2& tip : TipsOf(WithOuterSpurs(outer, gap, BorderOf(region), {.spot_nm = 2e6})))
    EXPECT_GE(tip.y(), gap);
}

TEST(WithOuterSpurs, DoNotCrossAGap) {
  // The spur of a very sharp corner would end in the other island, beyond the space of 5 mm.
  const MultiPolygon region =
      MakePolygonsOrDie("(0 0, 30 0, 30 20, 0 20); (35 0, 90 0, 90 20, 35 20)");
  const double gap = 1e6;
  const ConvexRing ring = {{10e6, 9e6}, {28.9e6, 10e6}, {10e6, 11e6}};
  const BorderGrid border = BorderOf(region);
  const ConvexRing spurred = WithOuterSpurs(ring, gap, border, {.spot_nm = 2e6});
  ASSERT_FALSE(spurred.empty());
  for (const Vector2& tip : spurred) EXPECT_LE(tip.x(), 29e6 + 1'000);
}

TEST(WithOuterSpurs, AreNoLongerThanThat) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 900 0, 900 20, 0 20)");
  const double gap = 1e6;
  const ConvexRing ring = {{10e6, 9.9e6}, {28e6, 10e6}, {10e6, 10.1e6}};
  const ConvexRing spurred = WithOuterSpurs(ring, gap, BorderOf(region), {.spot_nm = 2e6});
  EXPECT_GT(spurred.size(), 3u);
  for (const Vector2& tip : spurred) EXPECT_LE(tip.x(), 28e6 + kLongestSpur * gap + 1);
}

}  // namespace
}  // namespace slicefarm::exposure::corner_spurs_test
