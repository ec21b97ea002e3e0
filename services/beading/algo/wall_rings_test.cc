#include "services/beading/algo/wall_rings.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "common/model/paths_test.h"

namespace slicefarm::beading::wall_rings_test {
namespace {

Path Wall(std::string_view points, int32_t inset = 0) {
  Path wall = MakePathOrDie(points, /*closed=*/true);
  wall.inset = inset;
  return wall;
}

// The outline has two islands, the first one with a hole.
constexpr std::string_view kOutline =
    "(0 0, 20 0, 20 20, 0 20) (5 5, 5 15, 15 15, 15 5) ; (30 0, 40 0, 40 9, 30 9)";

TEST(NameRings, EachOutermostWallFollowsTheRingBesideIt) {
  std::vector<Path> walls = {
      Wall("(0.2 0.2, 19.8 0.2, 19.8 19.8, 0.2 19.8)"),
      Wall("(4.8 4.8, 4.8 15.2, 15.2 15.2, 15.2 4.8)"),
      Wall("(30.2 0.2, 39.8 0.2, 39.8 8.8, 30.2 8.8)"),
      Wall("(10 0.5, 10 4, 12 4)"),  // follows no ring
      Wall("(0.6 0.6, 19.4 0.6, 19.4 19.4, 0.6 19.4)", 1),
  };
  NameRings(MakePolygonsOrDie(kOutline), walls);
  EXPECT_EQ(walls[0].ring, 0);
  EXPECT_EQ(walls[1].ring, 1);
  EXPECT_EQ(walls[2].ring, 2);
  EXPECT_EQ(walls[3].ring, -1);
  EXPECT_EQ(walls[4].ring, -1);
}

TEST(NameRings, OpenWallsAndGapFillFollowNone) {
  std::vector<Path> walls = {MakePathOrDie("(0 5, 10 5)"), Wall("(1 1, 9 1, 9 9)")};
  walls[1].feature = Feature::kGapFill;
  NameRings(MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)"), walls);
  EXPECT_EQ(walls[0].ring, -1);
  EXPECT_EQ(walls[1].ring, -1);
}

}  // namespace
}  // namespace slicefarm::beading::wall_rings_test
