#include "services/exposure/algo/decompose/cut_region.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::cut_region_test {
namespace {

CutRegion RegionOf(const char* text) {
  const MultiPolygon islands = MakePolygonsOrDie(text);
  CutRegion region{{islands[0].outer}};
  region.rings.insert(region.rings.end(), islands[0].holes.begin(), islands[0].holes.end());
  return region;
}

double AreaOf(const std::vector<CutRegion>& regions) {
  double area = 0;
  for (const CutRegion& region : regions)
    for (const Polygon& ring : region.rings) area += SignedArea(ring);
  return area / 1e12;
}

CornerIndex At(const CutRegion& region, Coord x_mm, Coord y_mm) {
  for (size_t r = 0; r < region.rings.size(); ++r)
    for (size_t i = 0; i < region.rings[r].size(); ++i)
      if (region.rings[r][i] == Point{x_mm * kNmPerMm, y_mm * kNmPerMm}) return {r, i};
  ADD_FAILURE() << "no such corner";
  return {};
}

TEST(FirstReflex, FindsTheCornerOfAnL) {
  const CutRegion region = RegionOf("(0 0, 2 0, 2 1, 1 1, 1 2, 0 2)");
  EXPECT_EQ(FirstReflex(region), At(region, 1, 1));
  EXPECT_EQ(FirstReflex(RegionOf("(0 0, 2 0, 2 1)")), std::nullopt);
}

TEST(FirstReflex, AllCornersOfAHoleAre) {
  const CutRegion region = RegionOf("(0 0, 9 0, 9 9, 0 9) (3 3, 6 3, 6 6, 3 6)");
  EXPECT_EQ(FirstReflex(region), (CornerIndex{1, 0}));
  EXPECT_EQ(FirstReflex(region, {1, 3}), (CornerIndex{1, 3}));
}

TEST(CutAlong, PartsAnL) {
  CutRegion region = RegionOf("(0 0, 2 0, 2 1, 1 1, 1 2, 0 2)");
  const auto parts = CutAlong(region, At(region, 1, 1), At(region, 0, 0));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(AreaOf(parts), 3);
  for (const CutRegion& part : parts) EXPECT_EQ(FirstReflex(part), std::nullopt);
}

TEST(CutAlong, LeavesOutWhatBecomesStraight) {
  CutRegion region = RegionOf("(0 0, 2 0, 2 1, 1 1, 1 2, 0 2, 0 1)");
  const auto parts = CutAlong(region, At(region, 1, 1), At(region, 0, 1));
  ASSERT_EQ(parts.size(), 2u);
  for (const CutRegion& part : parts) EXPECT_EQ(part.PointCount(), 4u);
}

TEST(CutAlong, JoinsAHoleWithTheOuterRing) {
  CutRegion region = RegionOf("(0 0, 9 0, 9 9, 0 9) (3 3, 6 3, 6 6, 3 6)");
  const auto parts = CutAlong(region, At(region, 3, 3), At(region, 0, 0));
  ASSERT_EQ(parts.size(), 1u);
  ASSERT_EQ(parts[0].rings.size(), 1u);
  EXPECT_EQ(parts[0].PointCount(), 10u);
  EXPECT_EQ(AreaOf(parts), 72);
}

TEST(CutAlong, JoinsTwoHolesAndKeepsTheOuterRingFirst) {
  CutRegion region =
      RegionOf("(0 0, 19 0, 19 9, 0 9) (3 3, 6 3, 6 6, 3 6) (12 3, 15 3, 15 6, 12 6)");
  const auto parts = CutAlong(region, At(region, 6, 3), At(region, 12, 3));
  ASSERT_EQ(parts.size(), 1u);
  ASSERT_EQ(parts[0].rings.size(), 2u);
  EXPECT_GT(SignedArea(parts[0].rings[0]), 0);
  EXPECT_EQ(AreaOf(parts), 19 * 9 - 18);
}

TEST(CutAlong, SharesOutHoles) {
  CutRegion region =
      RegionOf("(0 0, 20 0, 20 10, 0 10) (2 2, 4 2, 4 8, 2 8) (14 2, 18 2, 18 8, 14 8)");
  // A cut between the existing corners would cross the holes: the ring gets new corners between
  // them.
  region.rings[0].insert(region.rings[0].begin() + 1, Point{10 * kNmPerMm, 0});
  region.rings[0].insert(region.rings[0].begin() + 4, Point{11 * kNmPerMm, 10 * kNmPerMm});
  const auto parts = CutAlong(region, At(region, 10, 0), At(region, 11, 10));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].rings.size(), 2u);
  EXPECT_EQ(parts[1].rings.size(), 2u);
  EXPECT_EQ(AreaOf(parts), 200 - 12 - 24);
}

TEST(CutAlong, ClosesTheBayOfAHole) {
  // A U-shaped hole: the cut across its mouth separates the inside of the U from the rest.
  CutRegion region =
      RegionOf("(0 0, 20 0, 20 20, 0 20) (5 5, 15 5, 15 15, 12 15, 12 8, 8 8, 8 15, 5 15)");
  const auto parts = CutAlong(region, At(region, 8, 15), At(region, 12, 15));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].rings.size() + parts[1].rings.size(), 3u);
  EXPECT_EQ(AreaOf({parts[0]}), 28);
  EXPECT_EQ(AreaOf(parts), 400 - 72);
}

}  // namespace
}  // namespace slicefarm::exposure::cut_region_test
