#include "services/milling/algo/push/edge_push.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "services/milling/algo/sample_parts_test.h"

namespace slicefarm::milling::edge_push_test {
namespace {

struct PushCase {
  const char* name;
  const char* cutter;
  FiberPoint a, b;
  double low, high;
};

TEST(PushEdge, ReachesWhatGeometrySays) {
  const double root = std::sqrt(0.5);
  for (const PushCase& c : {
           PushCase{"a point beside a cylinder", "cyl:10", {3, 3, 1}, {3, 3, 1}, -1, 7},
           PushCase{"a point beside a ball",
                    "ball:10",
                    {0, 2, 1},
                    {0, 2, 1},
                    -std::sqrt(5),
                    std::sqrt(5)},
           PushCase{"an upright edge beside the shaft", "ball:4", {0, 0, -9}, {0, 0, 9}, -2, 2},
           PushCase{"an upright edge that ends below the middle",
                    "ball:2",
                    {0, 0, -9},
                    {0, 0, 0.5},
                    -std::sqrt(0.75),
                    std::sqrt(0.75)},
           PushCase{"a level edge across",
                    "ball:2",
                    {0, -9, 0.5},
                    {0, 9, 0.5},
                    -std::sqrt(0.75),
                    std::sqrt(0.75)},
           PushCase{"a level edge along", "cyl:2", {-5, 0.6, 2}, {5, 0.6, 2}, -5.8, 5.8},
           PushCase{
               "a level edge at 45 degrees", "cyl:2", {-9, -9, 1}, {9, 9, 1}, -2 * root, 2 * root},
           PushCase{"a long level edge hardly above a cone's tip",
                    "cone:2:45",
                    {0, -99, 1e-6},
                    {0, 1, 1e-6},
                    -1e-6,
                    1e-6},
           PushCase{"a slope along, cylinder", "cyl:2", {-9, 0, -9}, {9, 0, 9}, -1, 10},
           PushCase{"a slope along, ball", "ball:2", {-9, 0, -9}, {9, 0, 9}, 1 - std::sqrt(2), 10},
           PushCase{"a slope along, bull",
                    "bull:2:0.25",
                    {-9, 0, -9},
                    {9, 0, 9},
                    -0.75 - 0.25 * (std::sqrt(2) - 1),
                    10},
           PushCase{
               "a slope along, cone that rises faster", "cone:2:30", {-9, 0, -9}, {9, 0, 9}, 0, 10},
           PushCase{"a slope along, cone that rises slower",
                    "cone:2:60",
                    {-9, 0, -9},
                    {9, 0, 9},
                    std::sqrt(1 / 3.0) - 1,
                    10},
       }) {
    const Reach reach = PushEdge(CutterOf(c.cutter), c.a, c.b);
    EXPECT_NEAR(reach.low, c.low, 1e-12) << c.name;
    EXPECT_NEAR(reach.high, c.high, 1e-12) << c.name;
  }
}

TEST(PushEdge, TouchingIsNoHit) {
  EXPECT_FALSE(PushEdge(CutterOf("cyl:2"), {0, 1, 3}, {5, 1, 3}).Hit());
  EXPECT_FALSE(PushEdge(CutterOf("ball:2"), {0, 0, 0}, {5, 0, 0}).Hit());
  EXPECT_FALSE(PushEdge(CutterOf("cone:2:45"), {0, 0.5, 0.5}, {0, 0.5, 0.5}).Hit());
  EXPECT_FALSE(PushEdge(CutterOf("cyl:2"), {0, 0, -1}, {5, 0, -0.5}).Hit());
}

/// The test compares the ends with a dense sample of the edge: no sample reaches farther, and one
/// comes close.
TEST(PushEdge, IsWhatADenseSampleReaches) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-4, 4);
  int hits = 0;
  for (const std::string_view text : kAllCutters) {
    const Cutter cutter = CutterOf(text);
    for (int round = 0; round < 400; ++round) {
      FiberPoint a{any(random), any(random), any(random)}, b{any(random), any(random), any(random)};
      if (round % 5 == 1) b.height = a.height;
      if (round % 5 == 2) b.across = a.across;
      if (round % 5 == 3) b.across = a.across, b.along = a.along;
      const Reach reach = PushEdge(cutter, a, b);
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (int i = 0; i <= 4000; ++i) {
        const double s = i / 4000.0, height = a.height + s * (b.height - a.height);
        const double across = a.across + s * (b.across - a.across);
        if (height < 0 || cutter.Width(height) <= std::abs(across)) continue;
        const double width = cutter.Width(height),
                     half = std::sqrt(width * width - across * across);
        low = std::min(low, a.along + s * (b.along - a.along) - half);
        high = std::max(high, a.along + s * (b.along - a.along) + half);
      }
      if (!(low < high)) continue;
      ++hits;
      ASSERT_TRUE(reach.Hit()) << text << " " << round;
      EXPECT_LE(reach.low, low + 1e-11) << text << " " << round;
      EXPECT_GE(reach.high, high - 1e-11) << text << " " << round;
      EXPECT_NEAR(reach.low, low, 0.05) << text << " " << round;
      EXPECT_NEAR(reach.high, high, 0.05) << text << " " << round;
    }
  }
  EXPECT_GT(hits, 1500);
}

}  // namespace
}  // namespace slicefarm::milling::edge_push_test
