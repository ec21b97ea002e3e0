#include "services/slicing/algo/section/adaptive_heights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "services/slicing/algo/topology/edge_table.h"

namespace slicefarm::slicing::adaptive_heights_test {
namespace {

using testing::Contains;

constexpr Coord kUm = 1'000;
constexpr Coord kMm = kNmPerMm;

/// Returns a body of revolution: rings of a radius at each height, closed by level discs.
IndexedMesh Turned(const std::vector<std::array<double, 2>>& radius_z_mm, int corners = 64) {
  IndexedMesh mesh;
  const auto ring = [&](size_t i, int k) {
    return static_cast<uint32_t>(i * static_cast<size_t>(corners) +
                                 static_cast<size_t>(k % corners));
  };
  for (const auto& [radius, z] : radius_z_mm)
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * std::numbers::pi * k / corners;
      mesh.vertices.push_back(
          {FromMm(radius * std::cos(angle)), FromMm(radius * std::sin(angle)), FromMm(z)});
    }
  for (size_t i = 0; i + 1 < radius_z_mm.size(); ++i)
    for (int k = 0; k < corners; ++k) {
      mesh.triangles.push_back({ring(i, k), ring(i, k + 1), ring(i + 1, k + 1)});
      mesh.triangles.push_back({ring(i, k), ring(i + 1, k + 1), ring(i + 1, k)});
    }
  for (int k = 1; k + 1 < corners; ++k) {
    mesh.triangles.push_back({ring(0, 0), ring(0, k + 1), ring(0, k)});
    const size_t top = radius_z_mm.size() - 1;
    mesh.triangles.push_back({ring(top, 0), ring(top, k), ring(top, k + 1)});
  }
  return mesh;
}

/// Returns a ball of 20 mm on a cylinder of 6 mm. The ball is cut off where its surface is flatter
/// than 10 degrees.
IndexedMesh BallOnColumn() {
  std::vector<std::array<double, 2>> shape = {{5, 0}, {5, 6}};
  for (int i = 10; i <= 170; i += 2) {
    const double angle = i * std::numbers::pi / 180;
    shape.push_back({10 * std::sin(angle), 6 + 10 - 10 * std::cos(angle)});
  }
  return Turned(shape);
}

HeightProblem ProblemOf(const IndexedMesh& mesh, std::vector<RangeInput> ranges = {}) {
  Coord top = 0;
  for (const Vertex& v : mesh.vertices) top = std::max(top, v.z);
  return {{&mesh}, top, 200 * kUm, std::move(ranges)};
}

/// Returns the largest step of a layer at a face: height * |normal z|.
double WorstCusp(const IndexedMesh& mesh, const std::vector<Coord>& tops, Coord lowest) {
  double worst = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vertex a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
    const auto d = [](Coord x) { return static_cast<double>(x); };
    const double x = d(b.y - a.y) * d(c.z - a.z) - d(b.z - a.z) * d(c.y - a.y),
                 y = d(b.z - a.z) * d(c.x - a.x) - d(b.x - a.x) * d(c.z - a.z),
                 z = d(b.x - a.x) * d(c.y - a.y) - d(b.y - a.y) * d(c.x - a.x);
    const auto [low, high] = std::minmax({a.z, b.z, c.z});
    if (low == high) continue;
    const double level = std::abs(z) / std::sqrt(x * x + y * y + z * z);
    for (size_t i = 1; i < tops.size(); ++i)
      if (tops[i] - tops[i - 1] > lowest && tops[i - 1] < high && low < tops[i])
        worst = std::max(worst, level * d(tops[i] - tops[i - 1]));
  }
  return worst;
}

TEST(AdaptiveTops, HoldTheCuspAtEachFace) {
  const IndexedMesh mesh = BallOnColumn();
  for (const Coord cusp : {50 * kUm, 100 * kUm, 150 * kUm}) {
    const AdaptiveHeights options = {.on = true, .cusp_nm = cusp};
    const auto tops = AdaptiveTops(ProblemOf(mesh), options);
    EXPECT_LE(WorstCusp(mesh, tops, options.min_nm + 20 * kUm), static_cast<double>(cusp)) << cusp;
    for (size_t i = 1; i < tops.size(); ++i) {
      EXPECT_GE(tops[i] - tops[i - 1], options.min_nm - 1) << i;
      EXPECT_LE(tops[i] - tops[i - 1], options.max_nm + 1) << i;
    }
  }
}

/// The test compares with equal layers of the same worst cusp.
TEST(AdaptiveTops, AreATenthFewerThanEqualLayersOfTheSameCusp) {
  const IndexedMesh mesh = BallOnColumn();
  const AdaptiveHeights options = {.on = true, .cusp_nm = 100 * kUm};
  const auto tops = AdaptiveTops(ProblemOf(mesh), options);
  const double cusp = WorstCusp(mesh, tops, 0);
  Coord height = 300 * kUm;
  std::vector<Coord> equal;
  for (;; height -= kUm) {
    equal = {200 * kUm};
    while (equal.back() + height / 2 < ProblemOf(mesh).top_nm)
      equal.push_back(equal.back() + height);
    if (WorstCusp(mesh, equal, 0) <= cusp) break;
  }
  EXPECT_LE(tops.size() * 10, equal.size() * 9) << tops.size() << " of " << equal.size();
}

TEST(AdaptiveTops, MeetLevelFacesExactly) {
  const IndexedMesh stairs =
      Turned({{9, 0}, {9, 1.234567}, {7, 1.234567}, {7, 3.3}, {5, 3.3}, {5, 7.00001}});
  for (const Coord cusp : {20 * kUm, 100 * kUm}) {
    const auto tops = AdaptiveTops(ProblemOf(stairs), {.on = true, .cusp_nm = cusp});
    EXPECT_THAT(tops, Contains(1'234'567));
    EXPECT_THAT(tops, Contains(3'300'000));
    EXPECT_EQ(tops.back(), 7'000'010);
    // Vertical walls do not limit the heights, so this is the smallest possible number of layers.
    EXPECT_EQ(tops.size(), 1u + 4 + 7 + 13);
  }
}

TEST(AdaptiveTops, NeighboursDifferByNoMoreThanTheRatio) {
  const IndexedMesh mesh = BallOnColumn();
  for (const double ratio : {1.2, 1.3, 2.0}) {
    const auto tops =
        AdaptiveTops(ProblemOf(mesh), {.on = true, .cusp_nm = 60 * kUm, .max_ratio = ratio});
    for (size_t i = 2; i < tops.size(); ++i) {
      const auto a = static_cast<double>(tops[i - 1] - tops[i - 2]),
                 b = static_cast<double>(tops[i] - tops[i - 1]);
      EXPECT_LE(std::max(a, b) / std::min(a, b), ratio + 1e-9) << ratio << ", layer " << i;
    }
  }
}

/// Without a limit of the ratio the problem is a shortest path: a breadth-first search finds
/// equally few layers.
TEST(AdaptiveTops, AreAsFewAsASearchFinds) {
  const IndexedMesh cone = Turned({{10, 0}, {9, 0.5}, {5, 1.2}, {4, 3}});
  const AdaptiveHeights options = {.on = true, .cusp_nm = 80 * kUm, .max_ratio = 100};
  const auto tops = AdaptiveTops(ProblemOf(cone), options);
  const auto height_at = [&](Coord from, Coord to) {
    const std::array<std::array<double, 2>, 3> runs = {{{1, .5}, {4, .7}, {1, 1.8}}};
    const std::array<Coord, 4> z = {0, 500 * kUm, 1'200 * kUm, 3 * kMm};
    double most = 300e3;
    for (size_t i = 0; i < 3; ++i)
      if (from < z[i + 1] && z[i] < to)
        most = std::min(most, 80e3 * std::hypot(runs[i][0], runs[i][1]) /
                                  (runs[i][0] * std::cos(std::numbers::pi / 64)));
    return most;
  };
  constexpr Coord kStep = 10 * kUm;
  std::vector<int> layers(301, -1);
  layers[20] = 1;
  for (Coord i = 20; i < 300; ++i)
    for (Coord k = i + 7; k <= std::min<Coord>(300, i + 30); ++k)
      if (layers[static_cast<size_t>(i)] > 0 &&
          static_cast<double>((k - i) * kStep) <= height_at(i * kStep, k * kStep) * 1.0005)
        if (int& to = layers[static_cast<size_t>(k)];
            to < 0 || to > layers[static_cast<size_t>(i)] + 1)
          to = layers[static_cast<size_t>(i)] + 1;
  EXPECT_EQ(static_cast<int>(tops.size()), layers[300]);
}

TEST(AdaptiveTops, RangesHaveTheirHeight) {
  const IndexedMesh mesh = BallOnColumn();
  const auto tops = AdaptiveTops(ProblemOf(mesh, {{2 * kMm, 5 * kMm, 150 * kUm}}), {.on = true});
  int inside = 0;
  for (size_t i = 1; i < tops.size(); ++i) {
    if (tops[i - 1] < 2 * kMm || tops[i - 1] >= 5 * kMm) continue;
    EXPECT_NEAR(static_cast<double>(tops[i] - tops[i - 1]), 150e3, 8e3) << i;
    ++inside;
  }
  EXPECT_GE(inside, 19);
}

/// Steps, slivers and objects lower than a layer: there are always layers, and they end near the
/// top.
TEST(AdaptiveTops, AlwaysFindAWay) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> rise(0.0001, 0.4), radius(1, 20);
  for (int run = 0; run < 40; ++run) {
    std::vector<std::array<double, 2>> shape = {{radius(random), 0}};
    for (int i = 0; i < 25; ++i) {
      shape.push_back({radius(random), shape.back()[1] + rise(random)});
      if (i % 3 == 0) shape.push_back({radius(random), shape.back()[1]});
    }
    const IndexedMesh mesh = Turned(shape, 12);
    const HeightProblem problem =
        ProblemOf(mesh, run % 2 ? std::vector<RangeInput>{{kMm, 2 * kMm, 333 * kUm}}
                                : std::vector<RangeInput>{});
    const AdaptiveHeights options = {
        .on = true, .cusp_nm = 20 * kUm * (1 + run % 5), .max_nm = 280 * kUm};
    const auto tops = AdaptiveTops(problem, options);
    ASSERT_FALSE(tops.empty());
    EXPECT_TRUE(std::is_sorted(tops.begin(), tops.end()));
    EXPECT_LE(std::abs(tops.back() - problem.top_nm), 170 * kUm) << run;
    // The order of faces must not change the result.
    IndexedMesh shuffled = mesh;
    std::ranges::shuffle(shuffled.triangles, random);
    EXPECT_EQ(
        AdaptiveTops({{&shuffled}, problem.top_nm, problem.first_nm, problem.ranges}, options),
        tops);
  }
}

TEST(AdaptiveTops, OfLessThanALayerIsTheFirstOne) {
  const IndexedMesh disc = Turned({{9, 0}, {9, 0.15}});
  EXPECT_EQ(AdaptiveTops(ProblemOf(disc), {.on = true}), std::vector<Coord>{200 * kUm});
}

}  // namespace
}  // namespace slicefarm::slicing::adaptive_heights_test
