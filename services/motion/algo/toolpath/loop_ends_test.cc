#include "services/motion/algo/toolpath/loop_ends.h"

#include <gtest/gtest.h>

#include "common/model/paths_test.h"

namespace slicefarm::motion::loop_ends_test {
namespace {

Path Loop(std::string_view points) {
  Path path = MakePathOrDie(points);
  path.closed = true;
  path.widths_nm = {400'000};
  return path;
}

TEST(BesideStart, IsOnTheBisectorOfTheCorner) {
  const Path square = Loop("(0 0, 10 0, 10 10, 0 10)");
  const Point inside = BesideStart(square, 200'000, /*left=*/true);
  EXPECT_NEAR(static_cast<double>(inside.x), 141'421, 1);
  EXPECT_NEAR(static_cast<double>(inside.y), 141'421, 1);
  const Point outside = BesideStart(square, 200'000, /*left=*/false);
  EXPECT_EQ(outside, (Point{-inside.x, -inside.y}));
}

TEST(BesideStart, IsBesideAStraightEdgeAndASpike) {
  EXPECT_EQ(BesideStart(Loop("(5 0, 10 0, 10 10, 0 10, 0 0)"), 200'000, true),
            (Point{5'000'000, 200'000}));
  EXPECT_EQ(BesideStart(Loop("(0 0, 10 0, 5 0)"), 200'000, true), (Point{0, 200'000}));
}

TEST(BesideStart, RepeatedPointsAreSkipped) {
  EXPECT_EQ(BesideStart(Loop("(5 0, 5 0, 10 0, 10 10, 0 10, 0 0)"), 200'000, true),
            (Point{5'000'000, 200'000}));
}

}  // namespace
}  // namespace slicefarm::motion::loop_ends_test
