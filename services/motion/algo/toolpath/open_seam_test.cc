#include "services/motion/algo/toolpath/open_seam.h"

#include <gtest/gtest.h>

#include "common/model/paths_test.h"

namespace slicefarm::motion::open_seam_test {
namespace {

SimplifiedPath Square(std::vector<Coord> widths_nm) {
  SimplifiedPath simple;
  simple.path = MakePathOrDie("(0 0, 10 0, 10 10, 0 10)");
  simple.path.closed = true;
  simple.path.widths_nm = std::move(widths_nm);
  simple.on_arc.assign(4, false);
  return simple;
}

TEST(WithOpenSeam, EndsBeforeItsBeginning) {
  const SimplifiedPath open = WithOpenSeam(Square({450'000}), 60'000);
  EXPECT_FALSE(open.path.closed);
  EXPECT_EQ(open.path.points.size(), 5u);
  EXPECT_EQ(open.path.points.back(), (Point{0, 60'000}));
  EXPECT_EQ(open.on_arc.size(), 4u);
  EXPECT_TRUE(WellFormed(open.path));
}

TEST(WithOpenSeam, DropsWholeEdges) {
  SimplifiedPath simple = Square({1, 2, 3, 4});
  simple.path.points = {{0, 0}, {10'000'000, 0}, {10'000'000, 10'000'000}, {0, 50'000}};
  const SimplifiedPath open = WithOpenSeam(simple, 60'000);
  ASSERT_EQ(open.path.points.size(), 4u);
  EXPECT_EQ(open.path.widths_nm.size(), 4u);
  EXPECT_EQ(open.on_arc.size(), 3u);
  EXPECT_NEAR(PathLength(open.path), PathLength(simple.path) - 60'000, 2);
}

TEST(WithOpenSeam, SmallLoopsAndLinesStay) {
  const SimplifiedPath square = Square({450'000});
  EXPECT_EQ(WithOpenSeam(square, 0).path, square.path);
  EXPECT_EQ(WithOpenSeam(square, 10'000'001).path, square.path);
  SimplifiedPath line = square;
  line.path.closed = false;
  EXPECT_EQ(WithOpenSeam(line, 60'000).path, line.path);
}

}  // namespace
}  // namespace slicefarm::motion::open_seam_test
