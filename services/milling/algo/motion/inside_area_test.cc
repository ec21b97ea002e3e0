#include "services/milling/algo/motion/inside_area.h"

#include <gtest/gtest.h>

#include <array>

#include "services/milling/algo/strategy/plane.h"

namespace slicefarm::milling::inside_area_test {
namespace {

Point P(double x, double y) { return PointOf({x, y}); }

struct LineCase {
  const char* name;
  Eigen::Vector2d a, b;
  bool inside;
};

/// The area is an L of 10 x 10 mm with a hole.
TEST(InsideArea, TellsLinesThatLeave) {
  const PolygonWithHoles area{{P(0, 0), P(10, 0), P(10, 4), P(4, 4), P(4, 10), P(0, 10)},
                              {{P(1, 1), P(1, 2), P(2, 2), P(2, 1)}}};
  for (const LineCase& c : {
           LineCase{"inside", {3, 1}, {9, 3}, true},
           LineCase{"along the outline", {0, 0}, {10, 0}, true},
           LineCase{"along a part of it", {4, 5}, {4, 9}, true},
           LineCase{"from corner to corner, outside", {10, 4}, {4, 10}, false},
           LineCase{"around the corner", {9, 2}, {2, 9}, false},
           LineCase{"through the hole", {0.5, 1.5}, {3, 1.5}, false},
           LineCase{"in the hole", {1.2, 1.2}, {1.8, 1.8}, false},
           LineCase{"away", {20, 20}, {30, 20}, false},
           LineCase{"onto the outline", {3, 3}, {4, 4}, true},
           LineCase{"a little over it", {3, 3}, {4.004, 3.5}, true},
           LineCase{"over it", {3, 3}, {5, 5}, false},
           LineCase{"no way", {3, 3}, {3, 3}, true},
       }) {
    EXPECT_EQ(InsideArea(area, std::array{c.a, c.b}), c.inside) << c.name;
    EXPECT_EQ(InsideArea(area, std::array{c.b, c.a}), c.inside) << c.name << ", back";
  }
}

}  // namespace
}  // namespace slicefarm::milling::inside_area_test
