#include "services/exposure/algo/scan/line_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace slicefarm::exposure::line_blocks_test {
namespace {

LineBlocks TwoBlocks() {
  return {.points = {{0, 0}, {10, 0}, {10, 1}, {0, 1}, {500, 0}, {510, 0}},
          .begin = {0, 4, 6},
          .odd = {false, true}};
}

TEST(InOrder, TheNearestFirst) {
  const std::vector<Point> points = InOrder(TwoBlocks(), {}, {600, 0});
  // From the far end backwards, then on from the nearer end of the other.
  EXPECT_EQ(points[0], (Point{510, 0}));
  EXPECT_EQ(points[1], (Point{500, 0}));
  EXPECT_EQ(points.size(), 6u);
}

TEST(InOrder, DirectionsStayWhereTheyMust) {
  ExposureOptions options;
  options.alternate_directions = false;
  const std::vector<Point> points = InOrder(TwoBlocks(), options, {600, 0});
  EXPECT_EQ(points[0], (Point{500, 0}));
  EXPECT_EQ(points[2], (Point{0, 0}));
}

TEST(InOrder, OfNothing) { EXPECT_TRUE(InOrder({}, {}, {}).empty()); }

}  // namespace
}  // namespace slicefarm::exposure::line_blocks_test
