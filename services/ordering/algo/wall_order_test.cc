#include "services/ordering/algo/wall_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/model/paths_test.h"

namespace slicefarm::ordering::wall_order_test {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

Path Wall(int32_t inset, std::string_view points) {
  Path path = MakePathOrDie(points, true);
  path.inset = inset;
  return path;
}

/// Returns two contours of two walls each.
std::vector<Path> TwoContours() {
  return {Wall(0, "(0 0, 40 0, 40 40, 0 40)"), Wall(1, "(1 1, 39 1, 39 39, 1 39)"),
          Wall(0, "(15 15, 15 25, 25 25, 25 15)"), Wall(1, "(14 14, 14 26, 26 26, 26 14)")};
}

std::vector<Path> Printed(std::vector<Path> walls, const WallRules& rules, Point from,
                          std::optional<Point> next = {}) {
  std::vector<Path*> pointers;
  for (Path& wall : walls) pointers.push_back(&wall);
  Route route(from);
  WorkBudget budget{10'000};
  PrintWalls(pointers, rules, next, route, budget);
  return route.TakePaths();
}

std::vector<int32_t> Insets(const std::vector<Path>& paths) {
  std::vector<int32_t> insets;
  for (const Path& path : paths) insets.push_back(path.inset);
  return insets;
}

TEST(PrintWalls, InsideOutContourByContour) {
  const auto printed = Printed(TwoContours(), {}, Mm(0, 0));
  EXPECT_THAT(Insets(printed), ElementsAre(1, 0, 1, 0));
  EXPECT_EQ(printed[0].points[0], Mm(1, 1));
  EXPECT_EQ(printed[1].points[0], Mm(0, 0));
}

// A middle bead between the long sides of a thin wall ends at the start of the outer wall, not at
// the other end of the wall.
TEST(PrintWalls, APieceOfAWallEndsAtTheSeamOfTheOneOutside) {
  Path middle = MakePathOrDie("(1 0.5, 39 0.5)", false);
  middle.inset = 1;
  std::vector<Path> walls = {Wall(0, "(0 0, 40 0, 40 1, 0 1)"), middle};
  walls[0].ring = 0;
  const std::vector<Point> seams = {Mm(0, 0)};
  for (const Point from : {Mm(0, 5), Mm(40, 0)}) {
    const auto printed = Printed(walls, {InsetOrder::kInnerFirst, seams}, from);
    EXPECT_THAT(Insets(printed), ElementsAre(1, 0));
    EXPECT_EQ(EndOf(printed[0]), Mm(1, 0.5));
  }
}

TEST(PrintWalls, TheLastPieceEndsOnTheWayToWhatIsNext) {
  std::vector<Path> walls = {MakePathOrDie("(0 0, 40 0)", false)};
  for (const Point next : {Mm(-5, 0), Mm(45, 0)}) {
    const auto printed = Printed(walls, {}, Mm(20, 20), next);
    EXPECT_EQ(EndOf(printed[0]), Mm(next.x < 0 ? 0 : 40, 0));
  }
}

TEST(PrintWalls, OutsideIn) {
  EXPECT_THAT(Insets(Printed(TwoContours(), {InsetOrder::kOuterFirst, {}}, Mm(0, 0))),
              ElementsAre(0, 1, 0, 1));
}

TEST(PrintWalls, TheOuterWallLastButOne) {
  std::vector<Path> walls = TwoContours();
  walls.push_back(Wall(2, "(2 2, 38 2, 38 38, 2 38)"));
  EXPECT_THAT(Insets(Printed(walls, {InsetOrder::kInnerOuterInner, {}}, Mm(0, 0))),
              ElementsAre(2, 0, 1, 0, 1));
}

// The brim's line farthest from the part is printed first, the line that touches the part last.
TEST(PrintWalls, FromTheOuterContourToTheHoles) {
  for (const Point from : {Mm(0, 0), Mm(20, 20)}) {
    const auto printed = Printed(TwoContours(), {InsetOrder::kTowardsHoles, {}}, from);
    EXPECT_THAT(Insets(printed), ElementsAre(0, 1, 1, 0));
    EXPECT_EQ(Bounds(printed[0].points).max, Mm(40, 40));
    EXPECT_EQ(Bounds(printed[3].points).max, Mm(25, 25));
  }
  EXPECT_TRUE(Printed({}, {InsetOrder::kTowardsHoles, {}}, {}).empty());
}

TEST(PrintWalls, NearestContourFirst) {
  const auto printed = Printed(TwoContours(), {}, Mm(24, 24));
  EXPECT_EQ(printed[0].points.size(), 4);
  EXPECT_EQ(printed[0].points[0], Mm(26, 26));
  EXPECT_EQ(printed[1].points[0], Mm(25, 25));
}

TEST(PrintWalls, LoopsOfAContourStartAtItsSeam) {
  const std::vector<Point> seams = {Mm(15, 25), Mm(1, 1), Mm(40, 0)};
  std::vector<Path> walls = TwoContours();
  walls[0].ring = 2;
  walls[2].ring = 0;
  const auto printed = Printed(walls, {InsetOrder::kInnerFirst, seams}, Mm(0, 0));
  std::vector<Point> starts;
  for (const Path& path : printed) starts.push_back(path.points[0]);
  EXPECT_THAT(starts, testing::UnorderedElementsAre(Mm(39, 1), Mm(40, 0), Mm(14, 26), Mm(15, 25)));
}

TEST(PrintWalls, InnerLoopsStartFurtherAlongIfAsked) {
  std::vector<Path> walls = {Wall(0, "(0 0, 40 0, 40 40, 0 40)"),
                             Wall(1, "(1 1, 39 1, 39 39, 1 39)"),
                             Wall(2, "(2 2, 38 2, 38 38, 2 38)")};
  walls[0].ring = 0;
  const std::vector<Point> seams = {Mm(20, 0)};
  const auto printed = Printed(walls, {InsetOrder::kOuterFirst, seams, /*stagger=*/true}, Mm(0, 0));
  ASSERT_EQ(printed.size(), 3u);
  EXPECT_EQ(printed[0].points[0], Mm(20, 0));
  EXPECT_EQ(printed[1].points[0], Mm(21, 1));
  EXPECT_EQ(printed[2].points[0], Mm(22, 2));
}

TEST(PrintWalls, OpenWallsTurnToTheNozzle) {
  Path line = Wall(0, "(0 0, 30 0)");
  line.closed = false;
  EXPECT_EQ(Printed({line}, {}, Mm(29, 1))[0].points[0], Mm(30, 0));
  line.reversible = false;
  EXPECT_EQ(Printed({line}, {}, Mm(29, 1))[0].points[0], Mm(0, 0));
}

TEST(PrintWalls, OrderOfInputDoesNotMatter) {
  std::vector<Path> walls = TwoContours();
  const auto want = Printed(walls, {}, Mm(3, 50));
  for (int turn = 0; turn < 4; ++turn) {
    std::rotate(walls.begin(), walls.begin() + 1, walls.end());
    EXPECT_EQ(Printed(walls, {}, Mm(3, 50)), want);
  }
}

}  // namespace
}  // namespace slicefarm::ordering::wall_order_test
