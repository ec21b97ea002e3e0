#include "common/geometry/polygon.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"

namespace slicefarm::polygon_test {
namespace {

TEST(Canonicalize, ForgetsStartsAndOrder) {
  MultiPolygon a = MakePolygonsOrDie(
      "(0 0, 9 0, 9 9, 0 9) (1 1, 2 1, 2 2) (5 5, 6 5, 6 6) ; (20 0, 21 0, 21 1)");
  MultiPolygon b = MakePolygonsOrDie(
      "(21 1, 20 0, 21 0) ; (9 9, 0 9, 0 0, 9 0) (6 6, 5 5, 6 5) (2 2, 1 1, 2 1)");
  EXPECT_NE(a, b);
  Canonicalize(a);
  Canonicalize(b);
  EXPECT_EQ(a, b);
}

TEST(Rings, AreAllThere) {
  const MultiPolygon a =
      MakePolygonsOrDie("(0 0, 9 0, 9 9, 0 9) (1 1, 2 1, 2 2) ; (20 0, 21 0, 21 1)");
  EXPECT_EQ(Rings(a).size(), 3u);
  EXPECT_EQ(PointCount(a), 10u);
}

}  // namespace
}  // namespace slicefarm::polygon_test
