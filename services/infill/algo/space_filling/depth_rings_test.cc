#include "services/infill/algo/space_filling/depth_rings.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/infill/algo/space_filling/fill_checks_test.h"

namespace slicefarm::infill::depth_rings_test {
namespace {

constexpr Coord kSpacing = 450'000;

TEST(DepthRings, ASquare) {
  const auto rings = RingsFrom(MakePolygonsOrDie("(0 0, 4 0, 4 4, 0 4)"), 500'000);
  ASSERT_EQ(rings.size(), 4U);
  for (int32_t step = 0; step < 4; ++step) {
    const Coord low = step * 500'000, high = 4'000'000 - low;
    EXPECT_EQ(rings[step].step, step);
    EXPECT_EQ(rings[step].points, (Polygon{{low, low}, {high, low}, {high, high}, {low, high}}));
  }
}

TEST(DepthRings, LieAtTheirDepth) {
  const PolygonWithHoles plate = Shape("plate");
  const std::vector<StepRing> rings = RingsFrom({plate}, kSpacing);
  ASSERT_FALSE(rings.empty());
  for (const StepRing& ring : rings) {
    for (const Point p : ring.points) {
      // Lines are mitered at corners of holes, and pulled together where a narrow part is omitted.
      const double depth = DistanceToBoundary(p, {plate});
      const double want = static_cast<double>(ring.step) * kSpacing;
      EXPECT_GE(depth, want - 0.15 * kSpacing);
      EXPECT_LE(depth, want + 0.15 * kSpacing);
    }
  }
}

TEST(DepthRings, OfNothingAndOfASliver) {
  EXPECT_TRUE(RingsFrom({}, kSpacing).empty());
  EXPECT_EQ(RingsFrom(MakePolygonsOrDie("(0 0, 5 0, 5 0.01, 0 0.01)"), kSpacing).size(), 1U);
  EXPECT_TRUE(RingsFrom(MakePolygonsOrDie("(0 0, 0.1 0, 0.1 0.1, 0 0.1)"), kSpacing).empty());
}

TEST(DepthRings, RefusesWhatItCannotFill) {
  const PolygonWithHoles square = Shape("square");
  EXPECT_TRUE(CheckRingSpacing(square, 450'000).ok());
  EXPECT_TRUE(CheckRingSpacing({}, 450'000).ok());
  for (const Coord spacing : {Coord{0}, Coord{-1}})
    EXPECT_EQ(DetailOf(CheckRingSpacing(square, spacing)).reason, Reason::kSettingOutOfRange);
  EXPECT_EQ(DetailOf(CheckRingSpacing(square, 1)).reason, Reason::kRequestTooLarge);
  EXPECT_EQ(DetailOf(CheckRingSpacing(square, 5'000)).reason, Reason::kRequestTooLarge);
}

}  // namespace
}  // namespace slicefarm::infill::depth_rings_test
