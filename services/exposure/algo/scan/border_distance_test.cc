#include "services/exposure/algo/scan/border_distance.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format.h"

namespace slicefarm::exposure::border_distance_test {
namespace {

TEST(DistanceToBorder, OfAFrame) {
  const MultiPolygon frame =
      MakePolygonsOrDie("(0 0, 30 0, 30 30, 0 30) (10 10, 10 20, 20 20, 20 10)");
  EXPECT_DOUBLE_EQ(DistanceToBorder({4e6, 15e6}, frame), 4e6);
  EXPECT_DOUBLE_EQ(DistanceToBorder({8e6, 15e6}, frame), 2e6);   // to the hole
  EXPECT_DOUBLE_EQ(DistanceToBorder({15e6, 15e6}, frame), 5e6);  // in the hole
  EXPECT_DOUBLE_EQ(DistanceToBorder({-3e6, -4e6}, frame), 5e6);  // outside, to a corner
}

TEST(IsWithin, LooksAtTheSideToo) {
  const MultiPolygon frame =
      MakePolygonsOrDie("(0 0, 30 0, 30 30, 0 30) (10 10, 10 20, 20 20, 20 10)");
  EXPECT_TRUE(IsWithin({4e6, 15e6}, 4e6, frame));
  EXPECT_FALSE(IsWithin({4e6, 15e6}, 4.1e6, frame));
  EXPECT_FALSE(IsWithin({15e6, 15e6}, 4e6, frame));  // in the hole
  EXPECT_FALSE(IsWithin({-9e6, 15e6}, 4e6, frame));
  EXPECT_FALSE(IsWithin({0, 0}, 0, {}));
}

}  // namespace
}  // namespace slicefarm::exposure::border_distance_test
