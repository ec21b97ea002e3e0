#include "services/planning/algo/seams/occupancy.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "services/planning/algo/rings/ring_shape.h"
#include "services/planning/algo/seams/rings_test.h"

namespace slicefarm::planning::occupancy_test {
namespace {

Occupancy PrismOf(std::string_view outlines, int layers) {
  Occupancy occupancy;
  for (int i = 1; i <= layers; ++i) occupancy.Add(MakePolygonsOrDie(outlines), i * Coord{200'000});
  occupancy.Build();
  return occupancy;
}

/// Returns the index of the outward direction that contains an angle.
int Towards(double degrees) { return static_cast<int>(degrees / 360 * kOutwards); }

TEST(Occupancy, AConvexPartIsInPlainView) {
  Occupancy box = PrismOf("(0 0, 20 0, 20 20, 0 20)", 100);
  EXPECT_EQ(box.Visibility(Mm(20, 10), FromMm(10), Towards(1)), 1);
  EXPECT_EQ(box.Visibility(Mm(0, 10), FromMm(10), Towards(181)), 1);
  EXPECT_EQ(box.Visibility(Mm(20, 20), FromMm(20), Towards(46)), 1);
}

TEST(Occupancy, LessIsSeenOfASlotAndNothingOfACave) {
  Occupancy slot = PrismOf("(0 0, 40 0, 40 18, 10 18, 10 22, 40 22, 40 40, 0 40)", 150);
  const double open = slot.Visibility(Mm(40, 10), FromMm(15), Towards(1));
  const double deep = slot.Visibility(Mm(20, 18), FromMm(15), Towards(91));
  EXPECT_EQ(open, 1);
  EXPECT_LT(deep, 0.3);
  Occupancy tube = PrismOf("(0 0, 40 0, 40 40, 0 40) (10 10, 10 30, 30 30, 30 10)", 250);
  EXPECT_EQ(tube.Visibility(Mm(10, 20), FromMm(25), Towards(1)), 0)
      << "the end of the tube is further away than it is wide";
  EXPECT_GT(tube.Visibility(Mm(10, 20), FromMm(45), Towards(1)), 0.1);
}

TEST(Occupancy, OfNothingHidesNothing) {
  Occupancy nothing;
  nothing.Build();
  EXPECT_EQ(nothing.Visibility(Mm(1, 1), 0, 0), 1);
}

TEST(Occupancy, LargePartsHaveCoarserCells) {
  Occupancy box = PrismOf("(-500 0, 500 0, 500 20, -500 20)", 100);
  EXPECT_EQ(box.Visibility(Mm(0, 20), FromMm(10), Towards(91)), 1);
}

}  // namespace
}  // namespace slicefarm::planning::occupancy_test
