#include "services/planning/algo/infill/cubic_octree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "common/geometry/measure.h"
#include "services/planning/algo/infill/stacks_test.h"
#include "services/planning/algo/infill/surface_points.h"

namespace slicefarm::planning::cubic_octree_test {
namespace {

constexpr double kPitch = 2e6;
constexpr double kReach = 60e6;
/// Of neighbouring planes, along a layer: the pattern's law.
constexpr double kLinePitch = 3 * kPitch;

double LengthOf(const std::vector<Polyline>& lines) {
  double length = 0;
  for (const Polyline& line : lines) length += Length(line);
  return length;
}

double LengthIn(const std::vector<Polyline>& lines, const Box& box) {
  double length = 0;
  for (const Polyline& line : lines) {
    constexpr int kParts = 2'000;
    const double part = Length(line) / kParts;
    for (int i = 0; i < kParts; ++i) {
      const double share = (i + 0.5) / kParts;
      const Point p{line[0].x + std::llround(share * static_cast<double>(line[1].x - line[0].x)),
                    line[0].y + std::llround(share * static_cast<double>(line[1].y - line[0].y))};
      if (box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y)
        length += part;
    }
  }
  return length;
}

// Points everywhere: the tree is full, and its lines are those of cubic infill.
TEST(CubicOctree, AFullTreeIsCubicInfill) {
  CubicOctree tree(kPitch, 0.4, kReach);
  const auto step = static_cast<Coord>(tree.StepNm());
  const Coord far = FromMm(30);
  for (Coord x = -far; x <= far; x += step)
    for (Coord y = -far; y <= far; y += step)
      for (Coord z = 0; z <= far; z += step) tree.Add({x, y}, z);
  const Box box{{-FromMm(20), -FromMm(20)}, {FromMm(20), FromMm(20)}};
  for (const double z : {3e6, 10.1e6, 17.77e6}) {
    const auto lines = tree.LinesAt(z);
    const double area = 40e6 * 40e6;
    // A few lines more or less meet the box; none is missing or double.
    EXPECT_NEAR(LengthIn(lines, box) * kPitch / area, 1, 0.06) << z;
    for (const Polyline& line : lines) {
      const Point way = line[1] - line[0];
      const double angle = std::atan2(static_cast<double>(way.y), static_cast<double>(way.x));
      const int family = static_cast<int>(std::lround((angle - 0.4) * 3 / (2 * std::numbers::pi)));
      const double turn = 0.4 + family * 2 * std::numbers::pi / 3;
      const double v = std::cos(turn) * static_cast<double>(line[0].y) -
                       std::sin(turn) * static_cast<double>(line[0].x);
      const double number = (v - z / std::numbers::sqrt2) / kLinePitch;
      EXPECT_NEAR(number, std::round(number), 1e-5);
    }
  }
}

TEST(CubicOctree, LinesThinOutAwayFromThePoints) {
  CubicOctree tree(kPitch, 0, kReach);
  const auto step = static_cast<Coord>(tree.StepNm());
  // A wall at x = -40 mm.
  for (Coord y = -FromMm(50); y <= FromMm(50); y += step)
    for (Coord z = -FromMm(40); z <= FromMm(40); z += step) tree.Add({-FromMm(40), y}, z);
  const auto density = [&](double from_mm, double to_mm) {
    double length = 0;
    for (int i = 0; i < 10; ++i)
      length += LengthIn(tree.LinesAt(i * 1.37e6),
                         {{FromMm(from_mm), -FromMm(20)}, {FromMm(to_mm), FromMm(20)}});
    return length * kPitch / (10 * (to_mm - from_mm) * 40 * 1e12);
  };
  const double near = density(-40, -36), middle = density(-20, -5), far = density(20, 40);
  EXPECT_NEAR(near, 1, 0.12);
  EXPECT_LT(middle, 0.75);
  EXPECT_GT(middle, 0.2);
  EXPECT_LT(far, 0.3);
  EXPECT_GT(far, 0);
}

// The order of points shows nowhere, and points in the same step tell nothing new.
TEST(CubicOctree, DependsOnThePointsAlone) {
  std::mt19937 random(3);
  std::vector<std::pair<Point, Coord>> points;
  for (int i = 0; i < 200; ++i)
    points.push_back({{FromMm(random() % 100 - 50.0), FromMm(random() % 100 - 50.0)},
                      FromMm(static_cast<double>(random() % 40))});
  CubicOctree one(kPitch, 0.1, kReach), other(kPitch, 0.1, kReach);
  for (const auto& [p, z] : points) one.Add(p, z);
  std::ranges::shuffle(points, random);
  for (int twice = 0; twice < 2; ++twice)
    for (const auto& [p, z] : points) other.Add(p, z);
  for (const double z : {0.0, 7e6, 33.3e6}) EXPECT_EQ(one.LinesAt(z), other.LinesAt(z));
}

// Planes lean by arctan 1 / sqrt 2: each line stands on the one below.
TEST(CubicOctree, LinesStandOnThoseBelow) {
  CubicOctree tree(kPitch, 0.2, kReach);
  const ObjectStack stack = Prism(100, "(-30 -30, 30 -30, 30 30, -30 30)");
  ForEachSurfacePoint(stack, static_cast<Coord>(tree.StepNm()),
                      [&](Point p, Coord z) { tree.Add(p, z); });
  const auto below = tree.LinesAt(8e6), above = tree.LinesAt(8.2e6);
  int loose = 0;
  for (const Polyline& line : above) {
    const Point middle{(line[0].x + line[1].x) / 2, (line[0].y + line[1].y) / 2};
    double nearest = 1e18;
    for (const Polyline& other : below)
      nearest = std::min(nearest, DistanceToSegment(middle, other[0], other[1]));
    loose += nearest > 0.2e6 / std::numbers::sqrt2 + 10;
  }
  // A plane begins where its cube does.
  EXPECT_LE(loose, static_cast<int>(above.size() / 10));
  EXPECT_GT(LengthOf(above), 0);
}

TEST(CubicOctree, WithoutPointsOnlyTheGreatestCubesHavePlanes) {
  const CubicOctree tree(kPitch, 0, kReach);
  const size_t lines = tree.LinesAt(5e6).size();
  EXPECT_GE(lines, 3u);
  EXPECT_LE(lines, 9u);
}

}  // namespace
}  // namespace slicefarm::planning::cubic_octree_test
