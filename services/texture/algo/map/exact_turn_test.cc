#include "services/texture/algo/map/exact_turn.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicefarm::texture::exact_turn_test {
namespace {

TEST(ExactTurn, TellsLeftFromRight) {
  EXPECT_EQ(ExactTurn({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(ExactTurn({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(ExactTurn({0, 0}, {1, 1}, {3, 3}), 0);
}

/// Products of doubles cancel here: 0.1 + 0.2 is not exactly 0.3.
TEST(ExactTurn, IsExactWhereDoublesAreNot) {
  const double step = std::nextafter(0.5, 1) - 0.5;
  for (int i = -4; i <= 4; ++i) {
    const Eigen::Vector2d p(0.5 + i * step, 0.5);
    EXPECT_EQ(ExactTurn({12, 12}, {24, 24}, p), i < 0 ? 1 : i > 0 ? -1 : 0) << i;
  }
}

}  // namespace
}  // namespace slicefarm::texture::exact_turn_test
