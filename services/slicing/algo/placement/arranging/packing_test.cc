#include "services/slicing/algo/placement/arranging/packing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/convex.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::slicing::packing_test {
namespace {

constexpr Coord kDistance = 6 * kNmPerMm;

Polygon Rectangle(double width, double height) {
  return ConvexHull(
      {{0, 0}, {FromMm(width), 0}, {FromMm(width), FromMm(height)}, {0, FromMm(height)}});
}

PackingTask TaskOf(double width, double height, size_t count) {
  return {.bed = Rectangle(100, 80),
          .shapes = {{MakeVariant(Rectangle(width, height), 0, kDistance)}},
          .sequence = std::vector<size_t>(count, 0),
          .standing = {},
          .max_plates = 0};
}

Packing PackOrDie(const PackingTask& task, PackingOrder order) {
  absl::StatusOr<Packing> packing = Pack(task, order, {});
  EXPECT_TRUE(packing.ok()) << packing.status();
  return *packing;
}

TEST(MakeVariant, TurnsByRightAnglesExactly) {
  const ShapeVariant turned = MakeVariant(Rectangle(30, 20), 90, kDistance);
  EXPECT_EQ(turned.hull, ConvexHull(MakeLineOrDie("(0 0, 0 30, -20 30, -20 0)")));
  EXPECT_EQ(turned.parts, std::vector<Polygon>{turned.hull});
  EXPECT_EQ(turned.box, Bounds(turned.hull));
}

TEST(Pack, StartsInTheMiddleOrInFront) {
  const PackingTask task = TaskOf(20, 10, 2);
  const Packing middle = PackOrDie(task, PackingOrder::kFromMiddle);
  EXPECT_EQ(middle.items[0]->translation, (Point{FromMm(40), FromMm(35)}));
  EXPECT_EQ(middle.items[1]->translation, (Point{FromMm(40), FromMm(19)}));
  const Packing front = PackOrDie(task, PackingOrder::kFromFront);
  EXPECT_EQ(front.items[0]->translation, (Point{0, 0}));
  EXPECT_EQ(front.items[1]->translation, (Point{FromMm(26), 0}));
}

TEST(Pack, OpensPlatesAsNeeded) {
  PackingTask task = TaskOf(60, 60, 3);
  const Packing three = PackOrDie(task, PackingOrder::kFromMiddle);
  EXPECT_EQ(three.plates, 3);
  EXPECT_EQ(three.items[2]->plate, 2);
  task.max_plates = 2;
  const Packing two = PackOrDie(task, PackingOrder::kFromMiddle);
  EXPECT_EQ(two.plates, 2);
  EXPECT_FALSE(two.items[2].has_value());
}

TEST(Pack, LeavesTheTooLargeOut) {
  const Packing none = PackOrDie(TaskOf(101, 10, 2), PackingOrder::kFromFront);
  EXPECT_EQ(none.plates, 0);
  EXPECT_FALSE(none.items[0] || none.items[1]);
}

TEST(Pack, KeepsAwayFromStandingParts) {
  PackingTask task = TaskOf(45, 80, 1);
  task.standing = {{{Rectangle(49, 80)}, 0}};
  const Packing packing = PackOrDie(task, PackingOrder::kFromMiddle);
  EXPECT_EQ(packing.items[0]->plate, 0);
  EXPECT_EQ(packing.items[0]->translation, (Point{FromMm(55), 0}));
}

TEST(Pack, TakesTheVariantThatFits) {
  PackingTask task = TaskOf(10, 95, 1);
  task.shapes[0].push_back(MakeVariant(Rectangle(10, 95), 90, kDistance));
  const Packing packing = PackOrDie(task, PackingOrder::kFromMiddle);
  ASSERT_TRUE(packing.items[0].has_value());
  EXPECT_EQ(packing.items[0]->variant, 1u);
}

TEST(Pack, CanBeCancelled) {
  const CancelToken cancelled([] { return true; });
  EXPECT_EQ(Pack(TaskOf(10, 10, 1), PackingOrder::kFromMiddle, cancelled).status().code(),
            absl::StatusCode::kCancelled);
}

}  // namespace
}  // namespace slicefarm::slicing::packing_test
