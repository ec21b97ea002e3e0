#include "services/slicing/algo/section/seam_area.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::seam_area_test {
namespace {

constexpr Coord kMm = kNmPerMm;

bool Holds(const MultiPolygon& area, Point p) {
  for (const PolygonWithHoles& island : area)
    if (Locate(p, island) != Side::kOutside) return true;
  return false;
}

TEST(SeamReach, GrowsWithWhatIsDoneToOutlines) {
  EXPECT_EQ(SeamReach({}), 300'000);
  EXPECT_EQ(SeamReach({.grow_nm = -100'000, .foot_nm = 200'000, .widen_holes_nm = 50'000}),
            650'000);
}

TEST(AroundBody, ReachesBeyondItAndFillsIt) {
  const MultiPolygon area = AroundBody(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)"), kMm);
  EXPECT_NEAR(Area(area) * 1e-12, 144, 1e-6);
}

TEST(AroundSurface, IsWhereItsLinesAreNear) {
  const Section cut = {
      .loops = {},
      .chains = {{{0, 0}, {5 * kMm, 0}, {10 * kMm, 0}}, {{20 * kMm, 0}, {20 * kMm, 4 * kMm}}}};
  const MultiPolygon area = AroundSurface(cut, kMm, 1'000);
  EXPECT_EQ(area.size(), 2u);
  EXPECT_NEAR(Area(area) * 1e-12, 12 * 2 + 6 * 2, 1e-6);
}

/// The area inside a closed painted band is not painted.
TEST(AroundSurface, EnclosesNothing) {
  const Polygon ring = {{0, 0}, {10 * kMm, 0}, {10 * kMm, 10 * kMm}, {0, 10 * kMm}};
  const MultiPolygon area = AroundSurface({{ring}, {}}, kMm, 1'000);
  EXPECT_NEAR(Area(area) * 1e-12, 12 * 12 - 8 * 8, 1e-6);
  EXPECT_FALSE(Holds(area, {5 * kMm, 5 * kMm}));
  for (const Point corner : ring) EXPECT_TRUE(Holds(area, corner));
}

TEST(AroundSurface, IsNothingWhereNothingIsCut) {
  EXPECT_TRUE(AroundSurface({}, kMm, 1'000).empty());
  EXPECT_TRUE(AroundSurface({{}, {{{5, 5}, {5, 5}}}}, kMm, 1'000).empty());
}

}  // namespace
}  // namespace slicefarm::slicing::seam_area_test
