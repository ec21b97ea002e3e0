#include "services/infill/algo/fields/blue_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace slicefarm::infill::blue_noise_test {
namespace {

TEST(BlueNoise, HasEachRankOnce) {
  for (const int side : {4, 9, 16}) {
    std::vector<int32_t> ranks = VoidAndCluster(side, 7);
    std::ranges::sort(ranks);
    for (int i = 0; i < side * side; ++i) ASSERT_EQ(ranks[static_cast<size_t>(i)], i);
  }
}

TEST(BlueNoise, DependsOnItsSeedAlone) {
  EXPECT_EQ(VoidAndCluster(8, 3), VoidAndCluster(8, 3));
  EXPECT_NE(VoidAndCluster(8, 3), VoidAndCluster(8, 4));
}

TEST(BlueNoise, RepeatsOverThePlane) {
  EXPECT_EQ(BlueNoiseAt(-1, -40), BlueNoiseAt(kBlueNoiseSide - 1, 2 * kBlueNoiseSide - 40));
}

/// Returns the mean squared error of the share of cells below a level, over all blocks of 8 x 8.
template <class Threshold>
double BlockError(double level, Threshold threshold) {
  double sum = 0;
  for (int by = 0; by < 4; ++by) {
    for (int bx = 0; bx < 4; ++bx) {
      double on = 0;
      for (int i = 0; i < 64; ++i) on += threshold(bx * 8 + i % 8, by * 8 + i / 8) < level;
      sum += (on / 64 - level) * (on / 64 - level);
    }
  }
  return sum / 16;
}

TEST(BlueNoise, IsMoreEvenThanChance) {
  std::vector<int> shuffled(1024);
  std::iota(shuffled.begin(), shuffled.end(), 0);
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(5));
  const auto white = [&](int x, int y) {
    return (shuffled[static_cast<size_t>(y * 32 + x)] + 0.5) / 1024;
  };
  for (const double level : {0.1, 0.3, 0.5, 0.8})
    EXPECT_LT(BlockError(level, BlueNoiseAt), 0.4 * BlockError(level, white)) << level;
}

}  // namespace
}  // namespace slicefarm::infill::blue_noise_test
