#include "common/geometry/covers.h"

#include <gtest/gtest.h>

namespace slicefarm::covers_test {
namespace {

TEST(Covers, IslandsAndTheirEdgesWithoutTheirHoles) {
  const MultiPolygon islands = {
      {{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {{{3, 3}, {3, 6}, {6, 6}, {6, 3}}}},
      {{{20, 0}, {29, 0}, {29, 9}, {20, 9}}, {}}};
  for (const Point p : {Point{1, 1}, {0, 4}, {3, 4}, {9, 9}, {25, 5}})
    EXPECT_TRUE(Covers(islands, p)) << p.x << ' ' << p.y;
  for (const Point p : {Point{4, 4}, {-1, 4}, {15, 5}, {30, 9}})
    EXPECT_FALSE(Covers(islands, p)) << p.x << ' ' << p.y;
  EXPECT_FALSE(Covers({}, {0, 0}));
}

}  // namespace
}  // namespace slicefarm::covers_test
