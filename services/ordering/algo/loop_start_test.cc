#include "services/ordering/algo/loop_start.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "common/model/paths_test.h"

namespace slicefarm::ordering::loop_start_test {
namespace {

using ::testing::ElementsAre;

Point Mm(double x, double y) { return {FromMm(x), FromMm(y)}; }

Path Loop(std::string_view points) { return MakePathOrDie(points, true); }

constexpr std::string_view kSquare = "(0 0, 10 0, 10 10, 0 10)";

TEST(NearestVertex, IsTheLeastOfEquals) {
  const Path square = Loop(kSquare);
  EXPECT_EQ(NearestVertex(square.points, Mm(9, 8)).at, Mm(10, 10));
  EXPECT_EQ(NearestVertex(square.points, Mm(5, 5)).at, Mm(0, 0));
  EXPECT_EQ(NearestVertex(Loop("(10 10, 0 10, 0 0, 10 0)").points, Mm(5, 5)).at, Mm(0, 0));
}

TEST(NearestToSeam, IsACornerThatIsNear) {
  // The loop is inside an outline with an inner corner at (5 5), 0.2 mm from the outline's edges.
  // The loop's corner is sqrt(2) times as far away.
  const Path ell = Loop("(0.2 0.2, 9.8 0.2, 9.8 4.8, 4.8 4.8, 4.8 9.8, 0.2 9.8)");
  EXPECT_EQ(NearestToSeam(ell.points, Mm(5, 5)).at, Mm(4.8, 4.8));
  EXPECT_EQ(NearestToSeam(ell.points, Mm(10, 0)).at, Mm(9.8, 0.2));
  const LoopPoint away = NearestToSeam(ell.points, Mm(7, 5));
  EXPECT_EQ(away, (LoopPoint{2, Mm(7, 4.8)}));
}

TEST(NearestToSeam, IsTheMiddleOfAnArcAroundIt) {
  // The loop passes the corner (5 5) of a hole in an arc. In each case another point of the arc is
  // slightly nearer.
  const Path around =
      Loop("(0 5.2, 5 5.2, 5.077 5.185, 5.141 5.141, 5.185 5.077, 5.2 5, 5.2 0, 0 0)");
  for (size_t nearer = 1; nearer <= 5; ++nearer) {
    Path loop = around;
    Point& point = loop.points[nearer];
    point.x -= 2'000, point.y -= 2'000;
    EXPECT_EQ(NearestToSeam(loop.points, Mm(5, 5)).at, loop.points[3]) << nearer;
  }
}

TEST(NearestToSeam, DoesNotCareForVerticesThatAreNoCorners) {
  // A wall of short edges that hardly turn.
  const Path wall = Loop("(0 0, 5 0, 5.3 0.01, 5.6 0.03, 20 0, 20 9, 0 9)");
  const LoopPoint start = NearestToSeam(wall.points, Mm(5.15, -0.2));
  EXPECT_EQ(start.edge, 1u);
  EXPECT_NEAR(ToMm(start.at.x), 5.144, 0.01);
  EXPECT_EQ(NearestToSeam(wall.points, Mm(5.32, -0.2)).at, Mm(5.3, 0.01)) << "20 um are no move";
}

TEST(Further, GoesTheWayOfPrinting) {
  const Path square = Loop(kSquare);
  const auto further = [&](LoopPoint from, double mm) {
    return Further(square.points, from, mm * kNmPerMm);
  };
  EXPECT_EQ(further({0, Mm(0, 0)}, 0), (LoopPoint{0, Mm(0, 0)}));
  EXPECT_EQ(further({0, Mm(0, 0)}, 4), (LoopPoint{0, Mm(4, 0)}));
  EXPECT_EQ(further({0, Mm(4, 0)}, 6), (LoopPoint{1, Mm(10, 0)}));
  EXPECT_EQ(further({3, Mm(0, 2)}, 5), (LoopPoint{0, Mm(3, 0)}));
  EXPECT_EQ(further({0, Mm(4, 0)}, 85), (LoopPoint{0, Mm(9, 0)})) << "twice around";
}

TEST(StartAt, RotatesToAVertex) {
  Path loop = Loop(kSquare);
  loop.widths_nm = {1, 2, 3, 4};
  StartAt({2, Mm(10, 10)}, loop);
  EXPECT_EQ(loop.points, MakeLineOrDie("(10 10, 0 10, 0 0, 10 0)"));
  EXPECT_THAT(loop.widths_nm, ElementsAre(3, 4, 1, 2));
}

TEST(StartAt, CutsAnEdge) {
  Path loop = Loop(kSquare);
  loop.widths_nm = {400, 500, 400, 400};
  StartAt({0, Mm(5, 0)}, loop);
  EXPECT_EQ(loop.points, MakeLineOrDie("(5 0, 10 0, 10 10, 0 10, 0 0)"));
  EXPECT_THAT(loop.widths_nm, ElementsAre(450, 500, 400, 400, 400));
  EXPECT_EQ(PathLength(loop), 40.0 * kNmPerMm);
}

TEST(StartAt, CutsTheClosingEdge) {
  Path loop = Loop(kSquare);
  StartAt({3, Mm(0, 6)}, loop);
  EXPECT_EQ(loop.points, MakeLineOrDie("(0 6, 0 0, 10 0, 10 10, 0 10)"));
  EXPECT_THAT(loop.widths_nm, ElementsAre(450'000));
}

}  // namespace
}  // namespace slicefarm::ordering::loop_start_test
