#include "common/geometry/rings/loop_point.h"

#include <gtest/gtest.h>

#include "common/geometry/polygon.h"

namespace slicefarm::loop_point_test {
namespace {

TEST(NearestLoopPoint, FindsCornersAndEdges) {
  const Polygon square = {{0, 0}, {FromMm(10), 0}, {FromMm(10), FromMm(10)}, {0, FromMm(10)}};
  const struct {
    Point to;
    LoopPoint nearest;
  } cases[] = {{{FromMm(5), FromMm(-3)}, {0, {FromMm(5), 0}}},
               {{FromMm(-1), FromMm(-1)}, {0, {0, 0}}},
               {{FromMm(1), FromMm(6)}, {3, {0, FromMm(6)}}},
               {{FromMm(9), FromMm(9.5)}, {2, {FromMm(9), FromMm(10)}}}};
  for (const auto& [to, nearest] : cases) EXPECT_EQ(NearestLoopPoint(square, to), nearest);
}

}  // namespace
}  // namespace slicefarm::loop_point_test
