#include "services/infill/algo/axis/axis_levels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "common/geometry/measure.h"

namespace slicefarm::infill::axis_levels_test {
namespace {

TEST(AxisLevels, LieAroundALine) {
  const std::vector<Polyline> axis = {{{0, 0}, {FromMm(40), 0}}};
  const auto levels = AxisLevels(axis, 1e6, 2e6, 6e6);
  ASSERT_EQ(levels.size(), 3u);
  for (size_t k = 0; k < levels.size(); ++k) {
    const double from_axis = 1 + 2.0 * static_cast<double>(k);
    EXPECT_TRUE(levels[k].closed);
    EXPECT_NEAR(ToMm(Perimeter(levels[k].points)), 80 + 2 * std::numbers::pi * from_axis,
                0.009 * from_axis);
    for (const Point p : levels[k].points)
      EXPECT_NEAR(ToMm(DistanceToSegment(p, axis[0][0], axis[0][1])), from_axis, from_axis / 250);
  }
}

TEST(AxisLevels, MergeWhereTheyMeet) {
  const std::vector<Polyline> axis = {{{0, 0}, {FromMm(40), 0}},
                                      {{0, FromMm(10)}, {FromMm(40), FromMm(10)}}};
  EXPECT_EQ(AxisLevels(axis, 4e6, 2e6, 5e6).size(), 2u);
  EXPECT_EQ(AxisLevels(axis, 4e6, 2e6, 7e6).size(), 3u);
}

TEST(AxisLevels, StartNoFartherThanAsked) {
  const std::vector<Polyline> axis = {{{0, 0}, {FromMm(40), 0}}};
  EXPECT_TRUE(AxisLevels(axis, 5e6, 2e6, 4e6).empty());
}

}  // namespace
}  // namespace slicefarm::infill::axis_levels_test
