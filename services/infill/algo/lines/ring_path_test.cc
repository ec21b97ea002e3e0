#include "services/infill/algo/lines/ring_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace slicefarm::infill::ring_path_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Returns the numbers of the corners that a path passes on a ring of four corners.
std::vector<Coord> Corners(const RingPath& path) {
  std::vector<Coord> corners;
  ForEachCorner({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, path, [&](Point p) { corners.push_back(p.x); });
  return corners;
}

TEST(RingPath, PassesTheCornersBetween) {
  EXPECT_THAT(Corners({0, 2, true}), ElementsAre(1, 2));
  EXPECT_THAT(Corners({2, 0, false}), ElementsAre(2, 1));
}

TEST(RingPath, PassesTheFirstPoint) {
  EXPECT_THAT(Corners({2, 1, true}), ElementsAre(3, 0, 1));
  EXPECT_THAT(Corners({1, 2, false}), ElementsAre(1, 0, 3));
}

TEST(RingPath, OnOneEdgeStraightOrAround) {
  EXPECT_THAT(Corners({1, 1, true}), IsEmpty());
  EXPECT_THAT(Corners({1, 1, false}), IsEmpty());
  EXPECT_THAT(Corners({1, 1, true, true}), ElementsAre(2, 3, 0, 1));
  EXPECT_THAT(Corners({1, 1, false, true}), ElementsAre(1, 0, 3, 2));
}

}  // namespace
}  // namespace slicefarm::infill::ring_path_test
