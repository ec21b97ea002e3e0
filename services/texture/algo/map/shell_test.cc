#include "services/texture/algo/map/shell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "services/texture/algo/map/exact_turn.h"

namespace slicefarm::texture::shell_test {
namespace {

/// Returns a loop on a circle of radius 2 at these angles, in turns.
FirstMap LoopAt(const std::vector<double>& turns) {
  FirstMap map;
  for (const double turn : turns)
    map.points.push_back(2 * Eigen::Vector2d(std::cos(2 * std::numbers::pi * turn),
                                             std::sin(2 * std::numbers::pi * turn)));
  return map;
}

BoundaryLoop Numbered(size_t count) {
  BoundaryLoop loop;
  for (size_t i = 0; i < count; ++i) loop.push_back(static_cast<int32_t>(i));
  return loop;
}

/// Checks that all triangles turn left, and that each edge has a triangle on both sides, except
/// edges of the loop and the frame. With the frame outside, the triangles then fill the ring once.
void ExpectFillsTheRing(const std::vector<double>& turns) {
  const FirstMap map = LoopAt(turns);
  const std::vector<BoundaryLoop> loops = {Numbered(turns.size())};
  const auto shell = ShellAround(map, loops);
  ASSERT_TRUE(shell.ok()) << shell.status() << " with " << turns.size() << " points";
  std::vector<Eigen::Vector2d> points = map.points;
  points.insert(points.end(), shell->points.begin(), shell->points.end());
  std::map<std::pair<int32_t, int32_t>, int> edges;
  for (const auto& t : shell->triangles) {
    EXPECT_EQ(ExactTurn(points[t[0]], points[t[1]], points[t[2]]), 1);
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  }
  size_t open = 0;
  for (const auto& [edge, times] : edges) {
    EXPECT_EQ(times, 1);
    open += edges.contains({edge.second, edge.first}) ? 0 : 1;
  }
  EXPECT_EQ(open, turns.size() + shell->frame.size());
  EXPECT_GE(shell->frame.size(), 24U);
  EXPECT_LE(shell->frame.size(), 200U);
}

TEST(ShellAround, FillsTheRingAroundLoopsOfAnySize) {
  for (const size_t count : {3U, 4U, 7U, 24U, 25U, 100U, 999U, 5000U}) {
    std::vector<double> turns;
    for (size_t i = 0; i < count; ++i)
      turns.push_back(static_cast<double>(i) / static_cast<double>(count));
    ExpectFillsTheRing(turns);
  }
}

TEST(ShellAround, FillsTheRingAroundUnevenLoops) {
  std::mt19937 random(4);
  for (int round = 0; round < 200; ++round) {
    // The lengths of edges differ by up to five powers of ten.
    std::vector<double> lengths(3 + random() % 300);
    double sum = 0;
    for (double& length : lengths)
      sum += length = std::pow(10.0, std::uniform_real_distribution(-5.0, 0.0)(random));
    std::vector<double> turns;
    double at = 0;
    for (const double length : lengths) {
      turns.push_back(at / sum);
      at += length;
    }
    bool half = false;  // an edge over half of the circle leaves the middle outside
    for (const double length : lengths) half |= length / sum > 0.45;
    if (!half) ExpectFillsTheRing(turns);
  }
}

}  // namespace
}  // namespace slicefarm::texture::shell_test
