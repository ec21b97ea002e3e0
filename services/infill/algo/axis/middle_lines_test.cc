#include "services/infill/algo/axis/middle_lines.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"

namespace slicefarm::infill::middle_lines_test {
namespace {

PolygonWithHoles BoxOf(double x0, double y0, double x1, double y1) {
  return {{{FromMm(x0), FromMm(y0)},
           {FromMm(x1), FromMm(y0)},
           {FromMm(x1), FromMm(y1)},
           {FromMm(x0), FromMm(y1)}},
          {}};
}

TEST(MiddleLines, OneAlongAStrip) {
  const auto paths = MiddleLines({BoxOf(1, 2, 9, 2.4)}, 450'000, 1'000'000);
  ASSERT_EQ(paths.size(), 1);
  EXPECT_FALSE(paths[0].closed);
  EXPECT_NEAR(ToMm(Distance(paths[0].points.front(), paths[0].points.back())), 7.6, 0.1);
  for (const Point p : paths[0].points) EXPECT_NEAR(ToMm(p.y), 2.2, 0.03);
}

TEST(MiddleLines, NoDots) {
  const MultiPolygon islands = {BoxOf(0, 0, 0.5, 0.5), BoxOf(3, 0, 3.5, 1.2), BoxOf(5, 0, 5.5, 3)};
  EXPECT_EQ(MiddleLines(islands, 450'000, 1'000'000).size(), 1);
  EXPECT_TRUE(MiddleLines({}, 450'000, 1'000'000).empty());
}

}  // namespace
}  // namespace slicefarm::infill::middle_lines_test
