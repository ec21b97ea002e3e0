#include "services/milling/algo/motion/mill_move.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace slicefarm::milling::mill_move_test {
namespace {

constexpr double kPi = std::numbers::pi;

struct MoveCase {
  const char* name;
  MillMove move;
  double length;
};

TEST(MillMove, HasTheLengthOfItsWay) {
  const Eigen::Vector3d from(10, 0, 5);
  for (const MoveCase& c : {
           MoveCase{"line", {.kind = MoveKind::kLine, .to_mm = {13, 4, 5}}, 5},
           MoveCase{"quarter", {.kind = MoveKind::kCounterClockwise, .to_mm = {0, 10, 5}}, 5 * kPi},
           MoveCase{"other way", {.kind = MoveKind::kClockwise, .to_mm = {0, 10, 5}}, 15 * kPi},
           MoveCase{"whole", {.kind = MoveKind::kClockwise, .to_mm = {10, 0, 5}}, 20 * kPi},
           MoveCase{"helix",
                    {.kind = MoveKind::kCounterClockwise, .to_mm = {-10, 0, 2}},
                    std::sqrt(100 * kPi * kPi + 9)},
       }) {
    EXPECT_NEAR(LengthOf(c.move, from), c.length, 1e-9) << c.name;
    Eigen::Vector3d last = from;
    double sum = 0;
    for (const Eigen::Vector3d& p : PointsOf(c.move, from, 1e-4)) {
      sum += (p - last).norm();
      if (c.move.kind != MoveKind::kLine) {
        EXPECT_NEAR(p.head<2>().norm(), 10, 1e-9) << c.name;
      }
      last = p;
    }
    EXPECT_EQ(last, c.move.to_mm) << c.name;
    EXPECT_NEAR(sum, c.length, 2e-4 * c.length) << c.name;
  }
}

}  // namespace
}  // namespace slicefarm::milling::mill_move_test
