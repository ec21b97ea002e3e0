#include "services/texture/algo/paths/level_lines.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/texture/algo/paths/line_field.h"
#include "services/texture/algo/paths/sample_maps_test.h"

namespace slicefarm::texture::level_lines_test {
namespace {

double LengthOf(const SurfaceMap& map, const LevelLine& line) {
  double length = 0;
  for (size_t i = 0; i < line.triangles.size(); ++i)
    length += (map.Position(PointOf(map, line.points[i + 1], line.triangles[i])) -
               map.Position(PointOf(map, line.points[i], line.triangles[i])))
                  .norm();
  return length;
}

TEST(LevelLines, CrossASquareFromLeftToRight) {
  const SurfaceMap map = MapFromAbove(FlatSquare(7, 10));
  const auto field = StraightField(map, {1, 0});
  // One of the levels runs along edges.
  const double levels[] = {0.5, 10 * 3 / 7.0, 9.99};
  const auto sets = LevelLines(map, field, levels);
  ASSERT_TRUE(sets.ok());
  for (const LevelSet& set : *sets) {
    ASSERT_EQ(set.lines.size(), 1u);
    const LevelLine& line = set.lines[0];
    EXPECT_FALSE(line.closed());
    EXPECT_NEAR(LengthOf(map, line), 10, 1e-9);
    EXPECT_NEAR(map.Position(PointOf(map, line.points[0], line.triangles[0])).x(), 0, 1e-12);
  }
}

TEST(LevelLines, StopAtHoles) {
  const SurfaceMap map = MapFromAbove(SquareWithHole(10, 10));
  const double levels[] = {1.5, 5.1};
  const auto sets = LevelLines(map, StraightField(map, {1, 0}), levels);
  ASSERT_TRUE(sets.ok());
  EXPECT_EQ((*sets)[0].lines.size(), 1u);
  ASSERT_EQ((*sets)[1].lines.size(), 2u);
  EXPECT_NEAR(LengthOf(map, (*sets)[1].lines[0]) + LengthOf(map, (*sets)[1].lines[1]), 6, 1e-9);
}

TEST(LevelLines, MayBeClosed) {
  const SurfaceMap map = MapFromAbove(FlatSquare(20, 10));
  std::vector<double> field;
  for (const Eigen::Vector2d& p : map.map_mm()) field.push_back((p - Eigen::Vector2d(5, 5)).norm());
  const double levels[] = {3};
  const auto sets = LevelLines(map, field, levels);
  ASSERT_TRUE(sets.ok());
  ASSERT_EQ((*sets)[0].lines.size(), 1u);
  EXPECT_TRUE((*sets)[0].lines[0].closed());
  EXPECT_NEAR(LengthOf(map, (*sets)[0].lines[0]), 2 * std::numbers::pi * 3, 0.2);
}

/// Each step is in one triangle, and the next step is in its neighbour.
TEST(LevelLines, StayInNeighbouringTriangles) {
  const SurfaceMap map = FlatMapOf(Cap(14, -0.5));
  const auto field = StraightField(map, {0.6, 0.8});
  const auto sets = LevelLines(map, field, CentredLevels(-1.5, 1.5, 0.05));
  ASSERT_TRUE(sets.ok());
  size_t steps = 0;
  for (const LevelSet& set : *sets) {
    for (const LevelLine& line : set.lines) {
      ASSERT_EQ(line.points.size(), line.triangles.size() + 1);
      steps += line.triangles.size();
      for (size_t i = 0; i < line.triangles.size(); ++i) {
        for (const EdgePoint& point : {line.points[i], line.points[i + 1]})
          EXPECT_NEAR(PointOf(map, point, line.triangles[i]).weights.sum(), 1, 1e-12);
        if (i > 0) {
          EXPECT_TRUE(map.Neighbour(line.triangles[i], 0) == line.triangles[i - 1] ||
                      map.Neighbour(line.triangles[i], 1) == line.triangles[i - 1] ||
                      map.Neighbour(line.triangles[i], 2) == line.triangles[i - 1]);
        }
      }
    }
  }
  EXPECT_GT(steps, 500u);
}

TEST(LevelLines, CanBeCancelled) {
  const SurfaceMap map = MapFromAbove(FlatSquare(3, 3));
  const double levels[] = {1};
  const auto sets =
      LevelLines(map, StraightField(map, {1, 0}), levels, CancelToken([] { return true; }));
  EXPECT_EQ(DetailOf(sets.status()).reason, Reason::kCancelled);
}

}  // namespace
}  // namespace slicefarm::texture::level_lines_test
