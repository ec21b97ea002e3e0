#include "services/ordering/algo/route.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::ordering::route_test {
namespace {

using ::testing::ElementsAre;

Path Line(bool closed) {
  Path path;
  path.closed = closed;
  path.points = {{0, 0}, {1, 0}, {2, 5}};
  path.widths_nm = {10, 20, 30};
  return path;
}

TEST(Reverse, TurnsPointsAndWidths) {
  Path path = Line(/*closed=*/false);
  Reverse(path);
  EXPECT_THAT(path.points, ElementsAre(Point{2, 5}, Point{1, 0}, Point{0, 0}));
  EXPECT_THAT(path.widths_nm, ElementsAre(30, 20, 10));
}

TEST(Reverse, LoopKeepsItsStart) {
  Path path = Line(/*closed=*/true);
  Reverse(path);
  EXPECT_THAT(path.points, ElementsAre(Point{0, 0}, Point{2, 5}, Point{1, 0}));
  EXPECT_THAT(path.widths_nm, ElementsAre(10, 30, 20));
}

TEST(Reverse, TwiceIsNothing) {
  for (const bool closed : {false, true}) {
    Path path = Line(closed);
    Reverse(path);
    Reverse(path);
    EXPECT_EQ(path, Line(closed));
  }
}

TEST(Route, FollowsTheNozzle) {
  Route route({7, 7});
  EXPECT_EQ(route.at(), (Point{7, 7}));
  route.Print(Line(/*closed=*/false));
  EXPECT_EQ(route.at(), (Point{2, 5}));
  route.Print(Line(/*closed=*/false), /*reversed=*/true);
  EXPECT_EQ(route.at(), (Point{0, 0}));
  route.PrintLoop(Line(/*closed=*/true), {1, {1, 0}});
  EXPECT_EQ(route.at(), (Point{1, 0}));
  EXPECT_EQ(route.TakePaths().size(), 3);
}

class Nothing : public Barrier {
 public:
  bool Parts(Point, Point) const override { return false; }
};

TEST(Route, LinksWhatLiesNearWithinAnIsland) {
  const auto stroke = [](Coord from) {
    Path path;
    path.points = {{from, 0}, {from + 5'000'000, 0}};
    path.widths_nm = {450'000};
    return path;
  };
  const Nothing nothing;
  Route route({0, 0}, 200'000);
  route.Enter({nullptr, &nothing});
  route.Print(stroke(0));
  route.Print(stroke(5'200'000));
  EXPECT_EQ(route.paths().size(), 3);
  route.Enter({nullptr, &nothing});  // another island
  route.Print(stroke(10'400'000));
  EXPECT_EQ(route.paths().size(), 4);
  route.Enter({});  // its outline is unknown
  route.Print(stroke(15'600'000));
  route.Print(stroke(20'800'000));
  EXPECT_EQ(route.paths().size(), 6);
}

TEST(Route, LoopsThatStayWholeAreNotLinked) {
  const auto loop = [](Feature feature, Coord inset) {
    Path path;
    path.feature = feature;
    path.closed = true;
    const Coord low = inset, high = 20'000'000 - inset;
    path.points = {{low, low}, {high, low}, {high, high}, {low, high}};
    path.widths_nm = {450'000};
    return path;
  };
  const Nothing nothing;
  for (const bool whole : {false, true}) {
    Route route({0, 0}, 200'000);
    route.Enter({nullptr, &nothing, whole});
    route.Print(loop(Feature::kPerimeter, 900'000));
    route.Print(loop(Feature::kPerimeter, 450'000));
    route.Print(loop(Feature::kExternalPerimeter, 0));
    EXPECT_EQ(route.paths().size(), whole ? 3U : 5U);
    EXPECT_EQ(route.paths()[0].closed, whole);
    // Lines are still linked.
    const auto line = [](Coord from) {
      Path path;
      path.points = {{from, 0}, {from + 5'000'000, 0}};
      path.widths_nm = {450'000};
      return path;
    };
    route.Enter({nullptr, &nothing, whole});
    const size_t before = route.paths().size();
    route.Print(line(0));
    route.Print(line(5'200'000));
    EXPECT_EQ(route.paths().size(), before + 3);
  }
}

}  // namespace
}  // namespace slicefarm::ordering::route_test
