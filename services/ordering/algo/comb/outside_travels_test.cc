#include "services/ordering/algo/comb/outside_travels.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "common/model/options/ordering_options.h"
#include "common/model/paths_test.h"

namespace slicefarm::ordering::outside_travels_test {
namespace {

/// Returns a block from x to x + 4 mm. It has a line inside and an outer wall that starts at the
/// bottom left corner.
FilledIsland Block(double x, double bottom, double top) {
  const auto ring = [&](double d) {
    return Polygon{{FromMm(x + d), FromMm(bottom + d)},
                   {FromMm(x + 4 - d), FromMm(bottom + d)},
                   {FromMm(x + 4 - d), FromMm(top - d)},
                   {FromMm(x + d), FromMm(top - d)}};
  };
  FilledIsland island;
  island.outline.outer = ring(0);
  Path wall = MakePathOrDie("(0 0, 1 0, 1 1)", true);
  wall.feature = Feature::kExternalPerimeter;
  wall.points = ring(0.225);
  Path line = MakePathOrDie("(0 0, 1 0)");
  line.points = {ring(1)[0], ring(1)[2]};
  island.walls = {wall, line};
  return island;
}

/// Returns two blocks with a high one between them.
FilledSection Blocks() {
  FilledSection section;
  section.islands = {Block(0, 0, 4), Block(10, -3, 10), Block(20, 0, 4)};
  return section;
}

bool Crosses(Point from, const std::vector<Point>& corners, Point to,
             const FilledSection& section) {
  EdgeStrips walls;
  for (const FilledIsland& island : section.islands) walls.AddRing(island.walls[0].points);
  walls.Build();
  for (const Point corner : corners) {
    if (walls.Crosses(from, corner)) return true;
    from = corner;
  }
  return walls.Crosses(from, to);
}

struct Outside : testing::Test {
  Travel Between(const Path& last, const Path& next, int64_t sights = 10'000) {
    WorkBudget budget{sights};
    OutsideTravels travels(section, options);
    return travels.Between(last, next, budget);
  }

  FilledSection section = Blocks();
  const Path& left = section.islands[0].walls[0];
  const Path& middle = section.islands[1].walls[0];
  const Path& right = section.islands[2].walls[0];
  TravelOptions options{.avoid_crossing = true};
};

TEST_F(Outside, GoesRoundWhatLiesBetween) {
  const Travel travel = Between(left, right);
  EXPECT_FALSE(travel.hidden);
  EXPECT_GE(travel.corners.size(), 2U);
  EXPECT_TRUE(Crosses(EndOf(left), {}, StartOf(right), section));
  EXPECT_FALSE(Crosses(EndOf(left), travel.corners, StartOf(right), section));
}

TEST_F(Outside, GoesRoundTheBlocksThemselves) {
  for (const auto& [from, to] : {std::pair(&middle, &right), std::pair(&right, &middle)}) {
    const Travel travel = Between(*from, *to);
    EXPECT_FALSE(travel.corners.empty());
    EXPECT_FALSE(Crosses(EndOf(*from), travel.corners, StartOf(*to), section));
  }
}

TEST_F(Outside, StraightWhereNothingIsCrossed) {
  section.islands[1] = Block(10, 20, 30);
  Path& wall = section.islands[0].walls[0];
  std::rotate(wall.points.begin(), wall.points.begin() + 1, wall.points.end());
  EXPECT_EQ(Between(left, right), Travel{});
}

TEST_F(Outside, StraightWhereNoOutlineIsKnown) {
  for (FilledIsland& island : section.islands) island.outline = {};
  EXPECT_EQ(Between(left, right), Travel{});
}

TEST_F(Outside, StraightFromAndToTheInside) {
  EXPECT_EQ(Between(section.islands[0].walls[1], right), Travel{});
  EXPECT_EQ(Between(left, section.islands[2].walls[1]), Travel{});
}

TEST_F(Outside, StraightIfTheDetourIsTooLong) {
  options.max_detour_mm = 0.1;
  EXPECT_EQ(Between(left, right), Travel{});
}

TEST_F(Outside, StraightIfNotAskedForOrWithoutABudget) {
  EXPECT_EQ(Between(left, right, 0), Travel{});
  options.avoid_crossing = false;
  EXPECT_EQ(Between(left, right), Travel{});
}

TEST_F(Outside, OutOfAHoleThereIsNoWay) {
  section.islands[1] = Block(-10, -10, 40);
  section.islands[1].outline = {MakePolygonsOrDie("(-10 -10, 15 -10, 15 15, -10 15)"
                                                  " (-5 -5, -5 10, 10 10, 10 -5)")
                                    .front()};
  section.islands[1].walls[0].points =
      MakeLineOrDie("(-5.2 -5.2, -5.2 10.2, 10.2 10.2, 10.2 -5.2)");
  EXPECT_EQ(Between(left, right), Travel{});
}

}  // namespace
}  // namespace slicefarm::ordering::outside_travels_test
