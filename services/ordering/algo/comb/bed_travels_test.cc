#include "services/ordering/algo/comb/bed_travels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/paths_within.h"

namespace slicefarm::ordering::bed_travels_test {
namespace {

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

MultiPolygon Box(double x0, double y0, double x1, double y1) {
  return {{{Mm(x0, y0), Mm(x1, y0), Mm(x1, y1), Mm(x0, y1)}, {}}};
}

const MultiPolygon kTravelArea = Difference(Box(0, 0, 256, 256), Box(0, 0, 18, 28));

Path Line(Point from, Point to) {
  Path path;
  path.points = {from, to};
  path.widths_nm = {400'000};
  return path;
}

/// Returns a layer with one block of two lines and a copy of it at each of `shifts`.
OrderedLayer LayerOf(const std::vector<Point>& shifts) {
  OrderedLayer layer;
  PathBlock& block = layer.blocks.emplace_back();
  block.paths = {Line(Mm(20, 2), Mm(19, 2)), Line(Mm(2, 29), Mm(2, 35))};
  int32_t copy = 0;
  for (const Point shift : shifts)
    layer.visits.push_back({.block = 0, .copy = copy++, .shift = shift});
  return layer;
}

/// Returns true if the straight line from a to b is free.
bool IsFree(Point a, Point b) { return PathsWithin(kTravelArea).Between(a, b).empty(); }

TEST(KeepInTravelArea, LeadsRoundAnAreaWithinABlock) {
  OrderedLayer layer = LayerOf({{}});
  KeepInTravelArea(kTravelArea, layer);
  const std::vector<Travel>& travels = layer.blocks[0].travels;
  ASSERT_EQ(travels.size(), 2u);
  EXPECT_THAT(travels[0].corners, testing::IsEmpty());
  ASSERT_EQ(travels[1].corners.size(), 1u);
  EXPECT_TRUE(IsFree(Mm(19, 2), travels[1].corners[0]));
  EXPECT_TRUE(IsFree(travels[1].corners[0], Mm(2, 29)));
}

TEST(KeepInTravelArea, LooksAtEachCopyWhereItStands) {
  OrderedLayer far = LayerOf({Mm(100, 100)});
  const OrderedLayer before = far;
  KeepInTravelArea(kTravelArea, far);
  EXPECT_EQ(far, before);
  OrderedLayer both = LayerOf({Mm(100, 100), {}});
  KeepInTravelArea(kTravelArea, both);
  EXPECT_EQ(both.blocks[0].travels.size(), 2u);
}

TEST(KeepInTravelArea, LeadsRoundAnAreaBetweenCopies) {
  OrderedLayer layer;
  layer.blocks.emplace_back().paths = {Line(Mm(0, 0), Mm(1, 0))};
  layer.visits = {{.block = 0, .copy = 0, .shift = Mm(20, 1)},
                  {.block = 0, .copy = 1, .shift = Mm(3, 31)},
                  {.block = 0, .copy = 2, .shift = Mm(200, 31)}};
  KeepInTravelArea(kTravelArea, layer);
  EXPECT_THAT(layer.visits[0].corners, testing::IsEmpty());
  ASSERT_EQ(layer.visits[1].corners.size(), 1u);
  EXPECT_TRUE(IsFree(Mm(21, 1), layer.visits[1].corners[0]));
  EXPECT_TRUE(IsFree(layer.visits[1].corners[0], Mm(3, 31)));
  EXPECT_THAT(layer.visits[2].corners, testing::IsEmpty());
}

TEST(KeepInTravelArea, LeavesWaysBetweenPassesAndBedsWithoutAreasAlone) {
  OrderedLayer layer = LayerOf({{}});
  const OrderedLayer before = layer;
  KeepInTravelArea({}, layer);
  EXPECT_EQ(layer, before);
  OrderedLayer passes;
  passes.blocks.emplace_back().paths = {Line(Mm(0, 0), Mm(1, 0))};
  passes.visits = {{.block = 0, .copy = 0, .pass = 0, .shift = Mm(20, 1)},
                   {.block = 0, .copy = 1, .pass = 1, .shift = Mm(3, 31)}};
  KeepInTravelArea(kTravelArea, passes);
  EXPECT_THAT(passes.visits[1].corners, testing::IsEmpty());
}

}  // namespace
}  // namespace slicefarm::ordering::bed_travels_test
