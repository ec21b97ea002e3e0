#include "services/slicing/algo/placement/arranging/convex_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::convex_parts_test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

double UnionArea(const std::vector<Polygon>& parts) {
  return Area(Union(parts, FillRule::kNonZero));
}

/// Returns a star with this number of corners, mostly concave.
Polygon Star(std::mt19937& random, int corners) {
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners, radius = 5e6 + random() % 20'000'000;
    ring.push_back(
        {std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  return ring;
}

TEST(ConvexParts, LeavesWhatIsConvex) {
  EXPECT_THAT(ConvexParts({}), IsEmpty());
  EXPECT_THAT(ConvexParts({{1, 1}}), SizeIs(1));
  EXPECT_THAT(ConvexParts(MakeLineOrDie("(0 0, 9 0, 9 9, 0 9)")), SizeIs(1));
  EXPECT_THAT(ConvexParts(MakeLineOrDie("(0 9, 9 9, 9 0, 0 0)")), SizeIs(1)) << "clockwise";
}

TEST(ConvexParts, CutsAnLInTwo) {
  const Polygon shape = MakeLineOrDie("(0 0, 60 0, 60 15, 15 15, 15 60, 0 60)");
  const std::vector<Polygon> parts = ConvexParts(shape);
  EXPECT_THAT(parts, SizeIs(2));
  EXPECT_EQ(UnionArea(parts), SignedArea(shape));
}

TEST(ConvexParts, GivesTheHullOfWhatCrossesItself) {
  const Polygon bow_tie = MakeLineOrDie("(0 0, 30 30, 30 0, 0 30)");
  EXPECT_THAT(ConvexParts(bow_tie), testing::ElementsAre(ConvexHull(bow_tie)));
  const Polygon line = MakeLineOrDie("(0 0, 30 0, 10 0)");
  EXPECT_THAT(ConvexParts(line), testing::ElementsAre(ConvexHull(line)));
}

TEST(ConvexParts, CoverWhatTheyAreMadeOf) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    const Polygon shape = Star(random, 4 + random() % 120);
    const std::vector<Polygon> parts = ConvexParts(shape);
    ASSERT_FALSE(parts.empty());
    ASSERT_LE(parts.size(), 12u);
    for (const Polygon& part : parts) ASSERT_EQ(part, ConvexHull(part));
    // Clipper rounds the points where parts and shape cross.
    EXPECT_LT(Area(Difference({{shape, {}}}, Union(parts, FillRule::kNonZero))), 1e9);
    if (shape.size() <= 12) {
      EXPECT_NEAR(UnionArea(parts), SignedArea(shape), 1e9);
    }
  }
}

}  // namespace
}  // namespace slicefarm::slicing::convex_parts_test
