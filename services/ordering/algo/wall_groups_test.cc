#include "services/ordering/algo/wall_groups.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/model/paths_test.h"

namespace slicefarm::ordering::wall_groups_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

Path Wall(int32_t inset, std::string_view points, bool closed = true) {
  Path path = MakePathOrDie(points, closed);
  path.inset = inset;
  return path;
}

TEST(GroupWalls, None) { EXPECT_THAT(GroupWalls({}), IsEmpty()); }

TEST(GroupWalls, NestedLoopsAreOneGroup) {
  Path outer = Wall(0, "(0 0, 20 0, 20 20, 0 20)");
  Path middle = Wall(1, "(1 1, 19 1, 19 19, 1 19)");
  Path inner = Wall(2, "(2 2, 18 2, 18 18, 2 18)");
  const auto groups = GroupWalls({&inner, &outer, &middle});
  ASSERT_THAT(groups, SizeIs(1));
  EXPECT_THAT(groups[0].walls, ElementsAre(&outer, &middle, &inner));
  EXPECT_THAT(groups[0].pairs, ElementsAre(WallPair{0, 1}, WallPair{1, 2}));
  EXPECT_EQ(&groups[0].Outermost(), &outer);
}

TEST(GroupWalls, AHoleHasItsOwn) {
  Path outer = Wall(0, "(0 0, 40 0, 40 40, 0 40)");
  Path outer_inside = Wall(1, "(1 1, 39 1, 39 39, 1 39)");
  Path hole = Wall(0, "(15 15, 15 25, 25 25, 25 15)");
  Path hole_inside = Wall(1, "(14 14, 14 26, 26 26, 26 14)");
  const auto groups = GroupWalls({&outer, &outer_inside, &hole, &hole_inside});
  ASSERT_THAT(groups, SizeIs(2));
  EXPECT_THAT(groups[0].walls, ElementsAre(&outer, &outer_inside));
  EXPECT_THAT(groups[1].walls, ElementsAre(&hole, &hole_inside));
}

TEST(GroupWalls, ALoopThatSplitsInsideStaysOneGroup) {
  Path outer = Wall(0, "(0 0, 40 0, 40 10, 0 10)");
  Path left = Wall(1, "(1 1, 15 1, 15 9, 1 9)");
  Path right = Wall(1, "(25 1, 39 1, 39 9, 25 9)");
  Path right_inside = Wall(2, "(26 2, 38 2, 38 8, 26 8)");
  const auto groups = GroupWalls({&outer, &left, &right, &right_inside});
  ASSERT_THAT(groups, SizeIs(1));
  EXPECT_THAT(groups[0].walls, ElementsAre(&outer, &left, &right, &right_inside));
  EXPECT_THAT(groups[0].pairs, ElementsAre(WallPair{0, 1}, WallPair{0, 2}, WallPair{2, 3}));
}

TEST(GroupWalls, AWallWithoutOneOutsideBeginsAGroup) {
  Path outer = Wall(0, "(0 0, 9 0, 9 9, 0 9)");
  Path lone = Wall(2, "(2 2, 7 2)", /*closed=*/false);
  EXPECT_THAT(GroupWalls({&outer, &lone}), SizeIs(2));
}

}  // namespace
}  // namespace slicefarm::ordering::wall_groups_test
