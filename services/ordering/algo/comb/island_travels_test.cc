#include "services/ordering/algo/comb/island_travels.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "common/geometry/text_format_test.h"
#include "common/model/options/ordering_options.h"
#include "common/model/paths_test.h"

namespace slicefarm::ordering::island_travels_test {
namespace {

Path PathOf(Feature feature, const char* points, bool closed = false) {
  Path path = MakePathOrDie(points, closed);
  path.feature = feature;
  return path;
}
Path Sparse(const char* points) { return PathOf(Feature::kInternalInfill, points); }
Path Top(const char* points) { return PathOf(Feature::kTopSolidInfill, points); }

/// Two arms 10 mm wide, joined at the bottom, with a slot of 4 mm between them.
constexpr const char* kFork = "(0 0, 24 0, 24 20, 14 20, 14 10, 10 10, 10 20, 0 20)";

Path OuterWall() {
  return PathOf(Feature::kExternalPerimeter,
                "(0.225 0.225, 23.775 0.225, 23.775 19.775, 14.225 19.775, 14.225 9.775,"
                " 9.775 9.775, 9.775 19.775, 0.225 19.775)",
                true);
}

/// Returns an inner wall that starts nearest to the corner at the origin.
Path InnerWall() { return PathOf(Feature::kPerimeter, "(0.675 0.675, 5 0.675, 5 5)", true); }

IslandPaths Routes(const std::vector<Path>& paths, const Meetings& meetings,
                   const TravelOptions& options = {}, int64_t sights = 100'000,
                   const char* outline = kFork) {
  WorkBudget budget{sights};
  FilledIsland island;
  island.outline = MakePolygonsOrDie(outline).front();
  for (const Path& path : paths)
    if (IsOuterWall(path)) island.walls.push_back(path);
  return PathsInIsland(island.outline, IslandEdges(island), paths, meetings, options, budget);
}

/// Returns the last path's travel when the curled area blocks it.
Travel OffCurled(const std::vector<Path>& paths, const char* curled,
                 const TravelOptions& options = {}) {
  WorkBudget budget{100'000};
  FilledIsland island;
  island.outline = MakePolygonsOrDie(kFork).front();
  CurlAvoidance routes(MakePolygonsOrDie(curled), Bounds(island.outline.outer));
  return PathsInIsland(island.outline, IslandEdges(island), paths, {}, options, budget, &routes)
      .travels.back();
}

TEST(PathsInIsland, KeepOffWhatHasCurledUp) {
  const std::vector<Path> paths = {Sparse("(1 2, 5 2)"), Sparse("(19 2, 23 2)")};
  const char* curled = "(11 0, 12 0, 12 4, 11 4)";
  const Travel inside = OffCurled(paths, curled);
  EXPECT_TRUE(inside.hidden) << "there is room inside";
  ASSERT_FALSE(inside.corners.empty());
  for (const Point corner : inside.corners) EXPECT_GT(corner.y, FromMm(4));
  const Travel seen = OffCurled(paths, curled, {.hide = false});
  EXPECT_FALSE(seen.hidden);
  EXPECT_EQ(seen.corners, inside.corners);
  EXPECT_TRUE(OffCurled(paths, "(11 6, 12 6, 12 9, 11 9)").corners.empty()) << "not in the way";
}

// The whole joint between the arms is curled, so that the only free path leads outside.
TEST(PathsInIsland, LeaveTheIslandForWhatHasCurledUp) {
  const std::vector<Path> paths = {Sparse("(1 2, 5 2)"), Sparse("(19 2, 23 2)")};
  const Travel outside = OffCurled(paths, "(11 -1, 12 -1, 12 11, 11 11)");
  EXPECT_FALSE(outside.hidden);
  ASSERT_FALSE(outside.corners.empty());
  for (const Point corner : outside.corners) EXPECT_GT(corner.y, FromMm(11));
  // No detour exists, so that the travel is straight.
  EXPECT_TRUE(OffCurled(paths, "(11 -1, 12 -1, 12 21, 11 21)").corners.empty());
}

std::vector<Travel> Travels(const std::vector<Path>& paths, const TravelOptions& options = {},
                            int64_t sights = 100'000) {
  return Routes(paths, {}, options, sights).travels;
}

struct Case {
  std::string name;
  std::vector<Path> paths;  ///< the test checks the last path's travel
  bool hidden = false;
  std::function<void(TravelOptions&)> set = [](TravelOptions&) {};
};

std::vector<Case> Cases() {
  const Path left = Sparse("(5 12, 5 18)"), right = Sparse("(19 18, 19 12)");
  const Path low = Sparse("(1 2, 5 2)"), far = Sparse("(19 2, 23 2)");
  return {
      {"Inside", {low, far}, true},
      {"AcrossTheSlot", {left, right}},
      {"RoundTheSlotInLessThanARetraction", {OuterWall(), left, right}, true},
      {"RoundTheSlot", {OuterWall(), left, right}, true, [](auto& o) { o.avoid_crossing = true; }},
      {"TheWayRoundIsTooLong",
       {OuterWall(), left, right},
       false,
       [](auto& o) {
         o.avoid_crossing = true;
         o.max_detour_mm = 1;
       }},
      {"TheWayRoundIsTooLongByItsRatio",
       {OuterWall(), left, right},
       false,
       [](auto& o) {
         o.avoid_crossing = true;
         o.max_detour_ratio = 0.05;
       }},
      {"NotAskedFor", {low, far}, false, [](auto& o) { o.hide = false; }},
      {"TooLong", {low, far}, false, [](auto& o) { o.longest_hidden_mm = 13.9; }},
      {"JustNotTooLong", {low, far}, true, [](auto& o) { o.longest_hidden_mm = 14.1; }},
      {"HoweverLong", {low, far}, true, [](auto& o) { o.longest_hidden_mm = 0; }},
      {"OverATopThatIsThere", {Top("(12 1, 12 3)"), low, far}},
      {"PastATop", {Top("(12 3, 12 5)"), low, far}, true},
      {"ToATop", {low, Top("(19 2, 23 2)")}},
      {"ToTheOuterWall", {Sparse("(1 2, 6 2)"), OuterWall()}},
      {"ToTheOuterWallNearBy", {Sparse("(1 2, 4 2)"), OuterWall()}, true},
      {"FromTheOuterWall", {OuterWall(), low}, true},
  };
}

class Hidden : public testing::TestWithParam<Case> {};

TEST_P(Hidden, OrInSight) {
  TravelOptions options;
  GetParam().set(options);
  std::vector<Path> paths = GetParam().paths;
  EXPECT_EQ(Travels(paths, options).back().hidden, GetParam().hidden);
}

INSTANTIATE_TEST_SUITE_P(IslandTravels, Hidden, testing::ValuesIn(Cases()),
                         [](const auto& info) { return info.param.name; });

TEST(IslandTravels, SomeCrossAnOuterWall) {
  const auto over_wall = [](const char* last, const char* next) {
    return Travels({OuterWall(), Sparse(last), Sparse(next)}, {}, /*sights=*/0).back().over_wall;
  };
  EXPECT_FALSE(over_wall("(1 2, 5 2)", "(19 2, 23 2)")) << "inside";
  // No detour is searched.
  EXPECT_TRUE(over_wall("(5 15, 9.2 19)", "(14.8 19, 20 15)"));
  EXPECT_FALSE(over_wall("(5 15, 9.6 15)", "(9.9 15, 5 14)")) << "at the end alone";
}

TEST(IslandTravels, OneForEachPathAndNoneToTheFirst) {
  const auto travels = Travels({Sparse("(1 2, 5 2)"), Sparse("(19 2, 23 2)"), Top("(3 5, 3 6)")});
  ASSERT_EQ(travels.size(), 3U);
  EXPECT_EQ(travels[0], Travel{});
  EXPECT_TRUE(travels[1].hidden);
}

// The arms of this fork are so long that a detour takes longer than a retraction.
TEST(IslandTravels, RoundALongSlotIsInSight) {
  const char* long_fork = "(0 0, 24 0, 24 30, 14 30, 14 10, 10 10, 10 30, 0 30)";
  const Path wall = PathOf(Feature::kExternalPerimeter,
                           "(0.225 0.225, 23.775 0.225, 23.775 29.775, 14.225 29.775,"
                           " 14.225 9.775, 9.775 9.775, 9.775 29.775, 0.225 29.775)",
                           true);
  const auto hidden = [&](const char* left, const char* right) {
    return Routes({wall, Sparse(left), Sparse(right)}, {}, {}, 100'000, long_fork)
        .travels.back()
        .hidden;
  };
  EXPECT_FALSE(hidden("(9 12, 9 29)", "(15 29, 15 12)"));
  EXPECT_TRUE(hidden("(9 29, 9 12)", "(15 12, 15 29)"));
}

TEST(IslandTravels, OverATopThatIsToComeIsHidden) {
  const auto travels = Travels({Sparse("(1 2, 5 2)"), Sparse("(19 2, 23 2)"), Top("(12 1, 12 3)")});
  EXPECT_TRUE(travels[1].hidden);
}

TEST(IslandTravels, TheWayRoundHasCorners) {
  TravelOptions options;
  options.avoid_crossing = true;
  const std::vector<Path> paths = {OuterWall(), Sparse("(5 12, 5 18)"), Sparse("(19 18, 19 12)")};
  EXPECT_EQ(Travels(paths, options).back().corners.size(), 2U);
  EXPECT_TRUE(Travels(paths, options)[1].corners.empty()) << "straight is clear of the walls";
  options.hide = false;
  EXPECT_EQ(Travels(paths, options).back().corners.size(), 2U);
  EXPECT_FALSE(Travels(paths, options).back().hidden);
  EXPECT_TRUE(Travels(paths, options, 0).back().corners.empty()) << "no budget";
}

TEST(IslandTravels, WithoutAnOutlineAllAreInSight) {
  WorkBudget budget{1'000};
  const std::vector<Path> paths = {Sparse("(1 2, 5 2)"), Sparse("(19 2, 23 2)")};
  const IslandPaths routes =
      PathsInIsland({}, IslandEdges({}), paths, {Point{}, Point{}}, {}, budget);
  EXPECT_EQ(routes.travels, std::vector<Travel>(2));
  EXPECT_EQ(routes.exit_travel, ExitTravel{});
}

/// Returns options that hide travels of up to 100 mm.
TravelOptions Far() {
  TravelOptions options;
  options.longest_hidden_mm = 100;
  return options;
}

// The layers of this part meet at the seam in the corner at the origin.
TEST(IslandTravels, GoesOnFromTheLayerBelow) {
  const auto from = [](const std::vector<Path>& paths, Point seam) {
    return Routes(paths, {seam, {}}, Far()).travels.front().hidden;
  };
  EXPECT_TRUE(from({Sparse("(1 1, 5 2)"), OuterWall()}, {0, 0})) << "beside the seam";
  EXPECT_TRUE(from({OuterWall()}, {0, 0})) << "a wall that starts at its seam";
  EXPECT_FALSE(from({Sparse("(20 2, 5 2)"), OuterWall()}, {0, 0}))
      << "the layer below may have left off outside of the walls";
  EXPECT_FALSE(from({Sparse("(20 2, 5 2)")}, {0, 0})) << "no wall to keep off";
}

TEST(IslandTravels, TheWayFromTheLayerBelowLeadsOverTheSeam) {
  const auto corners = [](const std::vector<Path>& paths, Point seam) {
    return Routes(paths, {seam, {}}).travels.front().corners;
  };
  const std::vector<Point> inner = {StartOf(InnerWall())};
  EXPECT_TRUE(corners({InnerWall(), OuterWall()}, {0, 0}).empty()) << "it is there";
  EXPECT_EQ(corners({Sparse("(20 2, 5 2)"), InnerWall(), OuterWall()}, {0, 0}), inner);
  const std::vector<Point> beside = corners({OuterWall()}, {FromMm(24), FromMm(20)});
  ASSERT_FALSE(beside.empty()) << "no path starts there";
  EXPECT_LT(beside.front().x, FromMm(24) - 225'000) << "inside of the outer wall";
  EXPECT_LT(Distance(beside.front(), {FromMm(24), FromMm(20)}), FromMm(1));
}

// The seam is in the slot's corner, and the inner walls of two layers start on either side of it.
TEST(IslandTravels, TheWayOverAChangeOfLayerKeepsInside) {
  const Point seam{FromMm(10), FromMm(10)};
  const Path in_arm = PathOf(Feature::kPerimeter, "(9.3 12, 9.3 18, 5 18)", true);
  const Path at_foot = PathOf(Feature::kPerimeter, "(12 9.2, 12 5, 9 5)", true);
  const ExitTravel exit_travel = *Routes({in_arm, OuterWall()}, {{}, seam}).exit_travel;
  const Travel arrival = Routes({at_foot, OuterWall()}, {seam, {}}).travels.front();
  const Point from =
      exit_travel.travel.corners.empty() ? exit_travel.to : exit_travel.travel.corners.back();
  FilledIsland island;
  island.outline = MakePolygonsOrDie(kFork).front();
  island.walls = {OuterWall()};
  const IslandEdges edges(island);
  ASSERT_FALSE(edges.Parts(from, exit_travel.to));
  ASSERT_FALSE(arrival.corners.empty());
  EXPECT_FALSE(edges.Parts(exit_travel.to, arrival.corners.front()));
  EXPECT_FALSE(edges.Parts(arrival.corners.back(), StartOf(at_foot)));
}

TEST(IslandTravels, GoesToWhereTheLayerAboveGoesOn) {
  const Point seam{0, 0};
  const auto exit_travel = [&](const std::vector<Path>& paths,
                               const TravelOptions& options = Far()) {
    return *Routes(paths, {{}, seam}, options).exit_travel;
  };
  EXPECT_EQ(exit_travel({OuterWall()}).to, EndOf(OuterWall())) << "is there already";
  const ExitTravel inside = exit_travel({InnerWall(), OuterWall(), Sparse("(5 2, 20 2)")});
  EXPECT_FALSE(inside.travel.hidden) << "the walls above may lie further in";
  EXPECT_TRUE(inside.travel.over_wall);
  EXPECT_TRUE(inside.travel.corners.empty());
  EXPECT_EQ(inside.to, StartOf(InnerWall())) << "where the layer above begins, too";
  const ExitTravel around = exit_travel({OuterWall(), Sparse("(19 12, 19 18)")});
  EXPECT_FALSE(around.travel.corners.empty());
  const ExitTravel near = exit_travel({InnerWall(), OuterWall(), Sparse("(5 2, 1 1)")});
  EXPECT_FALSE(near.travel.over_wall) << "too short for that";
  EXPECT_EQ(exit_travel({Sparse("(5 2, 20 2)")}).to, seam) << "no wall to keep off";
}

}  // namespace
}  // namespace slicefarm::ordering::island_travels_test
