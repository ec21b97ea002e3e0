#include "services/exposure/algo/decompose/link_choice.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::link_choice_test {
namespace {

CutRegion RegionOf(const char* text) {
  const MultiPolygon islands = MakePolygonsOrDie(text);
  CutRegion region{{islands[0].outer}};
  region.rings.insert(region.rings.end(), islands[0].holes.begin(), islands[0].holes.end());
  return region;
}

CornerIndex At(const CutRegion& region, double x_mm, double y_mm) {
  for (size_t r = 0; r < region.rings.size(); ++r)
    for (size_t i = 0; i < region.rings[r].size(); ++i)
      if (region.rings[r][i] == Point{FromMm(x_mm), FromMm(y_mm)}) return {r, i};
  ADD_FAILURE() << "no such corner";
  return {};
}

/// Returns the end of the cut from the corner at (x, y), in mm.
Point LinkFrom(const char* text, double x_mm, double y_mm, int32_t variant = 0) {
  const CutRegion region = RegionOf(text);
  LinkChoice choice;
  const auto link = choice.Choose(region, At(region, x_mm, y_mm), variant);
  EXPECT_TRUE(link);
  if (!link) return {};
  return link->extra.value_or(region.rings[link->end.ring][link->end.point]);
}

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

TEST(LinkChoice, ReflexCornersThatSeeEachOtherGoTogether) {
  EXPECT_EQ(LinkFrom("(0 0, 30 0, 15 10, 30 20, 0 20, 12 11)", 15, 10), Mm(12, 11));
}

TEST(LinkChoice, ABlockedCornerIsNotTaken) {
  // Case of the errata: (5, 6) is in region A, and all corners before it are on one side. Still,
  // edges at (3, 2.5) cross the line to it.
  const Point end = LinkFrom("(-5 0, 0 0, 0 -5, 10 -5, 10 10, 5 6, -2 8, 3 2.5, -5 8)", 0, 0);
  EXPECT_NE(end, Mm(5, 6));
  EXPECT_EQ(end, Mm(3, 2.5));
}

TEST(LinkChoice, AnExtensionGoesBeforeTheWeight) {
  // The two upper corners are convex and not sharp; (10, 20) is on the extension of the notch's
  // side.
  EXPECT_EQ(LinkFrom("(0 0, 20 0, 20 20, 10 20, 0 18, 0 10, 10 10, 10 5, 0 5)", 10, 10),
            Mm(10, 20));
}

TEST(LinkChoice, SharpCornersGiveWayToTheBisector) {
  const Point end = LinkFrom("(0 0, 50 1, 100 0, 100 10, 0 10)", 50, 1);
  EXPECT_EQ(end.y, 10 * kNmPerMm);
  EXPECT_NEAR(static_cast<double>(end.x), 50e6, 2e6);
}

TEST(LinkChoice, VariantsOfTheOnlyCornerEndBesideIt) {
  const char angle[] = "(0 0, 20 0, 20 10, 10 10, 10 20, 0 20)";
  EXPECT_EQ(LinkFrom(angle, 10, 10), Mm(0, 0));
  const Point left = LinkFrom(angle, 10, 10, 1), right = LinkFrom(angle, 10, 10, 2);
  EXPECT_NE(left, right);
  for (const Point end : {left, right}) {
    EXPECT_TRUE(end.x == 0 || end.y == 0);
    EXPECT_GT(Distance(end, Mm(0, 0)), 2e6);
  }
}

TEST(LinkChoice, NothingBehindACornerIsSeen) {
  // (20, 10) hides (30, 10) from (10, 10): the cut would pass it.
  EXPECT_NE(
      LinkFrom(
          "(0 0, 40 0, 40 20, 30 20, 30 10, 25 10, 25 20, 20 20, 20 10, 15 20, 10 20, 10 10, 0 10)",
          10, 10),
      Mm(30, 10));
}

TEST(LinkChoice, FromAHoleToTheOuterRing) {
  const Point end = LinkFrom("(0 0, 30 0, 30 30, 0 30) (10 10, 20 10, 20 20, 10 20)", 10, 10);
  EXPECT_TRUE(end == Mm(0, 0) || end.x == 0 || end.y == 0);
}

}  // namespace
}  // namespace slicefarm::exposure::link_choice_test
