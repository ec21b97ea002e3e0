#include "services/ordering/algo/path_key.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace slicefarm::ordering::path_key_test {
namespace {

using ::testing::ElementsAre;

Path Line(std::vector<Point> points, Coord width = 400) {
  Path path;
  path.points = std::move(points);
  path.widths_nm = {width};
  return path;
}

TEST(LeastPoint, DoesNotDependOnTheStart) {
  EXPECT_EQ(LeastPoint(Line({{5, 1}, {0, 9}, {0, 2}})), (Point{0, 2}));
  EXPECT_EQ(LeastPoint(Line({{0, 2}, {5, 1}, {0, 9}})), (Point{0, 2}));
}

TEST(OrderByGeometry, ForgetsTheInputOrder) {
  Path a = Line({{0, 0}, {9, 0}});
  Path wide = Line({{0, 0}, {9, 0}}, 500);
  Path bent = Line({{0, 0}, {9, 0}, {9, 9}});
  Path inner = Line({{0, 0}, {9, 0}});
  inner.inset = 1;
  Path far = Line({{1, 0}, {9, 0}});
  std::vector<Path*> paths = {&a, &wide, &bent, &inner, &far};
  std::sort(paths.begin(), paths.end());
  do {
    ASSERT_THAT(SortedByGeometry(paths), ElementsAre(&a, &wide, &bent, &inner, &far));
  } while (std::next_permutation(paths.begin(), paths.end()));
}

}  // namespace
}  // namespace slicefarm::ordering::path_key_test
