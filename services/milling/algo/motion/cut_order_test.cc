#include "services/milling/algo/motion/cut_order.h"

#include <gtest/gtest.h>

#include "services/milling/algo/strategy/plane.h"

namespace slicefarm::milling::cut_order_test {
namespace {

CutArea Square(double low, double high) {
  return {.area = {{PointOf({low, low}), PointOf({high, low}), PointOf({high, high}),
                    PointOf({low, high})},
                   {}},
          .passes = {}};
}

MilledStep Level(double z, std::vector<CutArea> areas) {
  return {.step = {MillPhase::kRoughing, z}, .areas = std::move(areas), .runs = {}};
}

/// Two pockets are under one face: one is cut to its bottom before the other.
TEST(CutOrder, GoesDownPocketByPocket) {
  const std::vector<MilledStep> levels = {Level(3, {Square(0, 10)}),
                                          Level(2, {Square(1, 4), Square(6, 9)}),
                                          Level(1, {Square(2, 3), Square(6, 9)})};
  const std::vector<AreaIndex> wanted = {{0, 0}, {1, 0}, {2, 0}, {1, 1}, {2, 1}};
  EXPECT_EQ(CutOrder(levels), wanted);
}

/// Two bosses of a casting become one area below, which is cut after both of them.
TEST(CutOrder, WaitsForAllThatLiesAbove) {
  const std::vector<MilledStep> levels = {Level(3, {Square(0, 2), Square(5, 7)}),
                                          Level(2, {Square(0, 7), Square(20, 22)}),
                                          Level(1, {Square(0, 7)})};
  const std::vector<AreaIndex> wanted = {{0, 0}, {0, 1}, {1, 0}, {2, 0}, {1, 1}};
  EXPECT_EQ(CutOrder(levels), wanted);
}

}  // namespace
}  // namespace slicefarm::milling::cut_order_test
