#include "common/geometry/boolean/without_holes.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"

namespace slicefarm::without_holes_test {
namespace {

TEST(WithoutHoles, KeepsOuterRings) {
  const MultiPolygon frame = MakePolygonsOrDie(
      "(0 0, 10 0, 10 10, 0 10) (2 2, 2 7, 7 7, 7 2) ; (3 3, 5 3, 5 5, 3 5) ; (20 0, 21 0, 21 1, "
      "20 1)");
  EXPECT_EQ(WithoutHoles(frame),
            MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10) ; (20 0, 21 0, 21 1, 20 1)"))
      << "the island in the hole is inside";
  const MultiPolygon plain = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  EXPECT_EQ(WithoutHoles(plain), plain);
  EXPECT_TRUE(WithoutHoles({}).empty());
}

}  // namespace
}  // namespace slicefarm::without_holes_test
