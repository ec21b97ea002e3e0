#include "services/exposure/algo/scan/line_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure::line_blocks_test {
namespace {

LineBlocks TwoBlocks() {
  return {.points = {{0, 0}, {10, 0}, {10, 1}, {0, 1}, {500, 0}, {510, 0}},
          .begin = {0, 4, 6},
          .odd = {false, true}};
}

TEST(InOrder, TheNearestFirst) {
  const std::vector<Point> points = InOrder(TwoBlocks(), {}, {600, 0});
  // The first block is scanned backwards from its far end, the next one from its nearer end.
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

/// Gas flows to +x: the block farther in this direction is first, and each block starts from its
/// end in this direction.
TEST(InOrder, AgainstTheFlowOfGas) {
  ExposureOptions options;
  options.jump_order = JumpOrder::kAgainstGas;
  EXPECT_EQ(InOrder(TwoBlocks(), options, {}),
            (std::vector<Point>{{510, 0}, {500, 0}, {0, 0}, {10, 0}, {10, 1}, {0, 1}}));
  options.gas_flow_deg = 180;
  EXPECT_EQ(InOrder(TwoBlocks(), options, {}),
            (std::vector<Point>{{0, 0}, {10, 0}, {10, 1}, {0, 1}, {500, 0}, {510, 0}}));
  // Lines in one direction: the last line is first, and each line keeps its direction.
  options.gas_flow_deg = 90;
  options.alternate_directions = false;
  const LineBlocks one_way = {
      .points = {{0, 0}, {10, 0}, {0, 1}, {10, 1}}, .begin = {0, 4}, .odd = {false}};
  EXPECT_EQ(InOrder(one_way, options, {}), (std::vector<Point>{{0, 1}, {10, 1}, {0, 0}, {10, 0}}));
}

TEST(InOrder, OfNothing) { EXPECT_TRUE(InOrder({}, {}, {}).empty()); }

}  // namespace
}  // namespace slicefarm::exposure::line_blocks_test
