#include "common/geometry/moved.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"

namespace slicefarm::moved_test {
namespace {

TEST(Moved, MovesRingsAndHoles) {
  const MultiPolygon at_origin =
      MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) (1 1, 2 1, 2 2) ; (20 0, 30 0, 30 10)");
  const MultiPolygon there =
      MakePolygonsOrDie("(3 -4, 12 -4, 12 5, 3 5) (4 -3, 5 -3, 5 -2) ; (23 -4, 33 -4, 33 6)");
  const Point by = {3'000'000, -4'000'000};
  EXPECT_EQ(Moved(at_origin, by), there);
  EXPECT_EQ(Moved(at_origin[0].outer, by), there[0].outer);
  EXPECT_TRUE(Moved(MultiPolygon{}, by).empty());
  EXPECT_TRUE(Moved(Polygon{}, by).empty());
}

}  // namespace
}  // namespace slicefarm::moved_test
