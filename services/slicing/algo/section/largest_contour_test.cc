#include "services/slicing/algo/section/largest_contour.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/measure.h"

namespace slicefarm::slicing::largest_contour_test {
namespace {

Polygon Square(double x_mm, double y_mm, double side_mm) {
  const Point low{FromMm(x_mm), FromMm(y_mm)}, high{FromMm(x_mm + side_mm), FromMm(y_mm + side_mm)};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

Polygon Hole(double x_mm, double y_mm, double side_mm) {
  Polygon hole = Square(x_mm, y_mm, side_mm);
  std::ranges::reverse(hole);
  return hole;
}

double Mm2(const MultiPolygon& outlines) { return Area(outlines) / 1e12; }

TEST(KeepLargestContour, HolesAndSmallerIslandsGo) {
  ObjectSection section;
  section.regions = {
      {.outlines = {
           {Square(0, 0, 10), {Hole(2, 2, 4)}}, {Square(3, 3, 1), {}}, {Square(20, 0, 9), {}}}}};
  KeepLargestContour(section);
  ASSERT_EQ(section.regions.size(), 1U);
  EXPECT_EQ(section.regions[0].outlines, (MultiPolygon{{Square(0, 0, 10), {}}}));
  EXPECT_TRUE(section.whole.empty());
}

TEST(KeepLargestContour, RegionsTileTheContour) {
  // The section is a ring with another region in its right half, and an island of a third region.
  const MultiPolygon whole = {{Square(0, 0, 10), {Hole(2, 2, 4)}}, {Square(20, 0, 5), {}}};
  ObjectSection section;
  const Polygon right = {
      {FromMm(7), 0}, {FromMm(10), 0}, {FromMm(10), FromMm(10)}, {FromMm(7), FromMm(10)}};
  const Polygon left = {{0, 0}, {FromMm(7), 0}, {FromMm(7), FromMm(10)}, {0, FromMm(10)}};
  section.regions = {{.settings = 0, .outlines = {{left, {Hole(2, 2, 4)}}}},
                     {.settings = 1, .outlines = {{right, {}}}},
                     {.settings = 2, .outlines = {{Square(20, 0, 5), {}}}}};
  section.whole = whole;
  KeepLargestContour(section);
  ASSERT_EQ(section.regions.size(), 2U);
  EXPECT_DOUBLE_EQ(Mm2(section.regions[0].outlines), 70);
  EXPECT_DOUBLE_EQ(Mm2(section.regions[1].outlines), 30);
  EXPECT_EQ(section.whole, (MultiPolygon{{Square(0, 0, 10), {}}}));
}

TEST(KeepLargestContour, EmptyAndPlainSectionsStay) {
  ObjectSection empty;
  KeepLargestContour(empty);
  EXPECT_EQ(empty, ObjectSection{});
  ObjectSection plain;
  plain.regions = {{.outlines = {{Square(0, 0, 10), {}}}}};
  const ObjectSection before = plain;
  KeepLargestContour(plain);
  EXPECT_EQ(plain, before);
}

}  // namespace
}  // namespace slicefarm::slicing::largest_contour_test
