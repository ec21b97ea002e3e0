#include "services/ordering/algo/comb/island_edges.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "common/model/paths_test.h"

namespace slicefarm::ordering::island_edges_test {
namespace {

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

/// Returns a plate of 20 mm with a hole of 8 mm in the middle. The walls are 0.5 mm inside the
/// edges.
FilledIsland Plate() {
  FilledIsland island;
  island.outline = MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20) (6 6, 6 14, 14 14, 14 6)").front();
  island.walls = {MakePathOrDie("(0.5 0.5, 19.5 0.5, 19.5 19.5, 0.5 19.5)", true),
                  MakePathOrDie("(5.5 5.5, 5.5 14.5, 14.5 14.5, 14.5 5.5)", true),
                  MakePathOrDie("(2 2, 18 2, 18 18, 2 18)", true)};
  for (size_t i : {0, 1}) island.walls[i].feature = Feature::kExternalPerimeter;
  island.walls[2].inset = 1;
  return island;
}

struct Route {
  const char* what;
  Point from, to;
  bool parted;
};

TEST(IslandEdges, PartWhatLeavesOrCrossesAnOuterWall) {
  const IslandEdges edges(Plate());
  for (const auto& [what, from, to, parted] : {
           Route{"inside", Mm(3, 3), Mm(17, 3), false},
           Route{"over an inner wall", Mm(1, 3), Mm(4, 3), false},
           Route{"over the hole", Mm(3, 10), Mm(17, 10), true},
           Route{"over the hole's wall alone", Mm(5.8, 10), Mm(3, 10), true},
           Route{"from the hole's wall inwards", Mm(5.5, 10), Mm(3, 10), false},
           Route{"from the hole's wall outwards", Mm(5.5, 10), Mm(10, 10), true},
           Route{"from wall to wall", Mm(0.5, 10), Mm(5.5, 10), false},
           Route{"out of the plate", Mm(3, 3), Mm(-3, 3), true},
       }) {
    EXPECT_EQ(edges.Parts(from, to), parted) << what;
    EXPECT_EQ(edges.Parts(to, from), parted) << what;
  }
}

// A loop may start inside an edge. Its start is a whole point beside the edge, on either side.
TEST(IslandEdges, StartsInsideEdgesOfAWallArePartOfIt) {
  FilledIsland island = Plate();
  island.walls[1].points[1] = Mm(4.7, 14.5);  // the left side of the hole's wall leans
  const IslandEdges edges(island);
  for (int i = 1; i < 100; ++i) {
    const double share = i / 100.0;
    const Point start = Mm(5.5 - 0.8 * share, 5.5 + 9 * share) + Point{i % 3 - 1, 0};
    for (const Point near : {start - Mm(0.4, 0), start - Mm(0.4, 0.3)}) {
      EXPECT_FALSE(edges.Parts(near, start)) << i;
      EXPECT_FALSE(edges.Parts(start, near)) << i;
      EXPECT_TRUE(edges.Parts(near, start + Mm(0.002, 0))) << i;
    }
  }
}

TEST(IslandEdges, OfAnOpenOuterWall) {
  FilledIsland island;
  island.outline = MakePolygonsOrDie("(0 0, 10 0, 10 1, 0 1)").front();
  island.walls = {MakePathOrDie("(0.5 0.5, 9.5 0.5)")};
  island.walls[0].feature = Feature::kExternalPerimeter;
  const IslandEdges edges(island);
  EXPECT_TRUE(edges.Parts(Mm(5, 0.2), Mm(5, 0.8)));
  EXPECT_FALSE(edges.Parts(Mm(1, 0.2), Mm(9, 0.2)));
}

// Path simplification moves beads by some micrometres.
TEST(IslandEdges, GrazesWhatPassesAnOuterWallTooNear) {
  const IslandEdges edges(Plate());
  for (const auto& [what, from, to, near] : {
           Route{"past a corner of the hole's wall", Mm(2, 8.9), Mm(8.9, 2), false},
           Route{"a hair beside the corner", Mm(2, 8.98), Mm(9, 1.98), true},
           Route{"from a wall to a wall", Mm(0.5, 10), Mm(5.5, 10), false},
           Route{"far inside", Mm(3, 3), Mm(17, 3), false},
           Route{"too short to tell", Mm(5.48, 5.4), Mm(5.48, 5.9), false},
       }) {
    EXPECT_FALSE(near && edges.Parts(from, to)) << what;
    EXPECT_EQ(edges.Grazes(from, to), near) << what;
    EXPECT_EQ(edges.Grazes(to, from), near) << what;
  }
}

// Only the two ends of a whole travel may be close to walls.
TEST(IslandEdges, GrazesNearTheCornersOfAWay) {
  const IslandEdges edges(Plate());
  const std::vector<Point> past = {Mm(3, 3), Mm(5.48, 10), Mm(3, 17)};
  const std::vector<Point> over = {Mm(3, 3), Mm(5.6, 10), Mm(3, 17)};
  const std::vector<Point> beside = {Mm(3, 3), Mm(5.4, 10), Mm(3, 17)};
  EXPECT_TRUE(edges.Grazes(past));
  EXPECT_FALSE(edges.Grazes(past, 0));
  EXPECT_TRUE(edges.Grazes(over, 0));
  EXPECT_FALSE(edges.Grazes(beside));
}

TEST(IslandEdges, KnowTheInside) {
  const IslandEdges edges(Plate());
  EXPECT_TRUE(edges.Surrounds(Mm(3, 10)));
  EXPECT_FALSE(edges.Surrounds(Mm(10, 10)));
  EXPECT_FALSE(edges.empty());
  EXPECT_TRUE(IslandEdges({}).empty());
}

}  // namespace
}  // namespace slicefarm::ordering::island_edges_test
