#include "services/planning/algo/infill/cubic_octree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/planning/algo/infill/sparse_areas.h"
#include "services/planning/algo/infill/stacks_test.h"
#include "services/planning/algo/infill/surface_points.h"

namespace slicefarm::planning::cubic_octree_test {
namespace {

constexpr double kPitch = 2e6;
constexpr double kReach = 60e6;
constexpr int kSkins = 5;
/// Distance of neighbouring planes along a layer, by the pattern's formula.
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

CubicOctree FullTree(double angle_rad) {
  CubicOctree tree(kPitch, angle_rad, kReach);
  const auto step = static_cast<Coord>(tree.StepNm());
  const Coord far = FromMm(30);
  for (Coord x = -far; x <= far; x += step)
    for (Coord y = -far; y <= far; y += step)
      for (Coord z = 0; z <= far; z += step) tree.Add({x, y}, z, 0);
  tree.Grow();
  return tree;
}

/// Builds the tree as planning does: from roofs alone, or from all surfaces.
CubicOctree TreeOf(const ObjectStack& stack, bool roofs_alone, double angle_rad = 0.2) {
  CubicOctree tree(kPitch, angle_rad, kReach);
  const auto each = roofs_alone ? ForEachRoofPoint : ForEachSurfacePoint;
  each(stack, {kSkins, kSkins}, static_cast<Coord>(tree.StepNm()),
       [&](Point p, Coord z, double around) { tree.Add(p, z, around); });
  ForEachInnerPoint(stack, static_cast<Coord>(tree.BodyStepNm()),
                    [&](Point p, Coord z) { tree.AddBody(p, z); });
  tree.Grow();
  return tree;
}

// With places everywhere the tree is full, and its lines equal the lines of cubic infill.
TEST(CubicOctree, AFullTreeIsCubicInfill) {
  const CubicOctree tree = FullTree(0.4);
  const Box box{{-FromMm(20), -FromMm(20)}, {FromMm(20), FromMm(20)}};
  for (const double z : {3e6, 10.1e6, 17.77e6}) {
    const auto lines = tree.LinesAt(z);
    const double area = 40e6 * 40e6;
    // A few more or fewer lines may meet the box, but no line is missing or double.
    EXPECT_NEAR(LengthIn(lines, box) * kPitch / area, 1, 0.06) << z;
    for (const Polyline& line : lines) {
      const Point path = line[1] - line[0];
      const double angle = std::atan2(static_cast<double>(path.y), static_cast<double>(path.x));
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
  // Places on a wall at x = -40 mm.
  for (Coord y = -FromMm(50); y <= FromMm(50); y += step)
    for (Coord z = -FromMm(40); z <= FromMm(40); z += step) tree.Add({-FromMm(40), y}, z, 0);
  tree.Grow();
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

// The order of points has no effect, and neither have further points in the same step.
TEST(CubicOctree, DependsOnThePointsAlone) {
  std::mt19937 random(3);
  std::vector<std::pair<Point, Coord>> points;
  for (int i = 0; i < 200; ++i)
    points.push_back({{FromMm(random() % 100 - 50.0), FromMm(random() % 100 - 50.0)},
                      FromMm(static_cast<double>(random() % 40))});
  CubicOctree one(kPitch, 0.1, kReach), other(kPitch, 0.1, kReach);
  for (const auto& [p, z] : points) one.Add(p, z, 0);
  std::ranges::shuffle(points, random);
  for (int twice = 0; twice < 2; ++twice)
    for (const auto& [p, z] : points) other.Add(p, z, 0);
  one.Grow(), other.Grow();
  for (const double z : {0.0, 7e6, 33.3e6}) EXPECT_EQ(one.LinesAt(z), other.LinesAt(z));
}

// Planes lean by arctan 1 / sqrt 2, so each line rests on the line below.
TEST(CubicOctree, LinesStandOnThoseBelow) {
  const CubicOctree tree = TreeOf(Prism(100, "(-30 -30, 30 -30, 30 30, -30 30)"), false);
  const auto below = tree.LinesAt(8e6), above = tree.LinesAt(8.2e6);
  int loose = 0;
  for (const Polyline& line : above) {
    const Point middle{(line[0].x + line[1].x) / 2, (line[0].y + line[1].y) / 2};
    double nearest = 1e18;
    for (const Polyline& other : below)
      nearest = std::min(nearest, DistanceToSegment(middle, other[0], other[1]));
    loose += nearest > 0.2e6 / std::numbers::sqrt2 + 10;
  }
  // The only loose lines are at the begin of a plane, where its cube begins.
  EXPECT_LE(loose, static_cast<int>(above.size() / 10));
  EXPECT_GT(LengthOf(above), 0);
}

TEST(CubicOctree, WithoutPlacesOnlyTheGreatestCubesHavePlanes) {
  CubicOctree tree(kPitch, 0, kReach);
  tree.Grow();
  const size_t lines = tree.LinesAt(5e6).size();
  EXPECT_GE(lines, 1u);
  EXPECT_LE(lines, 9u);
}

struct Shape {
  const char* name;
  ObjectStack stack;
};

std::vector<Shape> Shapes() {
  const auto square = MakePolygonsOrDie("(-25 -25, 25 -25, 25 25, -25 25)");
  std::vector<Shape> shapes;
  shapes.push_back({"box", Prism(150, "(-30 -30, 30 -30, 30 30, -30 30)")});
  shapes.push_back({"step", StackOf(120, [&](int i) {
                      return i < 60 ? square : MakePolygonsOrDie("(-25 -25, 3 -25, 3 25, -25 25)");
                    })});
  shapes.push_back(
      {"dome", StackOf(100, [&](int i) { return FastOffset(square, -FromMm(0.0024 * i * i)); })});
  shapes.push_back(
      {"flat cone", StackOf(40, [&](int i) { return FastOffset(square, -FromMm(0.6 * i)); })});
  return shapes;
}

/// Counts the places on lines of a full tree that are in `region` but on no line of `tree`.
int Missing(const CubicOctree& full, const CubicOctree& tree, const MultiPolygon& region,
            double z_nm, int& looked_at) {
  const auto lines = tree.LinesAt(z_nm);
  int missing = 0;
  for (const Polyline& line : full.LinesAt(z_nm)) {
    constexpr int kParts = 400;
    for (int k = 0; k < kParts; ++k) {
      const Point path = line[1] - line[0];
      const double share = (k + 0.5) / kParts;
      const Point p = line[0] + Point{std::llround(share * static_cast<double>(path.x)),
                                      std::llround(share * static_cast<double>(path.y))};
      if (!Inside(p, region)) continue;
      ++looked_at;
      missing += std::ranges::none_of(lines, [&](const Polyline& other) {
        return DistanceToSegment(p, other[0], other[1]) < 100;
      });
    }
  }
  return missing;
}

// A roof on this sparse infill gets the same support as on cubic infill.
TEST(CubicOctree, CarriesRoofsLikeCubicInfill) {
  const CubicOctree full = FullTree(0.2);
  const std::vector<Shape> shapes = Shapes();
  ASSERT_FALSE(shapes.empty());
  for (const Shape& shape : shapes) {
    const auto areas =
        SparseAreas(shape.stack, InnerAreas(shape.stack, 1'350'000), {kSkins, kSkins});
    for (const bool roofs_alone : {false, true}) {
      const CubicOctree tree = TreeOf(shape.stack, roofs_alone);
      int looked_at = 0, missing = 0;
      for (size_t i = 0; i + 1 < areas.size(); ++i) {
        // With `roofs_alone`, surfaces that lean more than 45 degrees do not count.
        const Coord wider = roofs_alone ? kStackHeight + 10'000 : 0;
        const MultiPolygon roof = Difference(areas[i], FastOffset(areas[i + 1], wider));
        if (Area(roof) < 1e12) continue;
        missing += Missing(full, tree, roof,
                           static_cast<double>(shape.stack[i].z_nm - kStackHeight / 2), looked_at);
      }
      EXPECT_GT(looked_at, 300) << shape.name;
      EXPECT_EQ(missing, 0) << shape.name << (roofs_alone ? ", roofs alone" : "");
    }
  }
}

// A cube of 37 pitches, which equals a cube of 100 mm at 15 %.
TEST(CubicOctree, SavesAThirdOfABox) {
  constexpr double kHalf = 18.5 * kPitch;
  const auto half = static_cast<Coord>(kHalf);
  const MultiPolygon square = {{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, {}}};
  const auto layers = static_cast<int>(2 * half / kStackHeight);
  const ObjectStack stack = StackOf(layers, [&](int) { return square; });
  const Box box{{-half, -half}, {half, half}};
  for (const bool roofs_alone : {false, true}) {
    for (const double angle : {0.0, 0.3, 0.7853981}) {
      CubicOctree tree = TreeOf(stack, roofs_alone, angle);
      double length = 0, volume = 0;
      for (int i = kSkins; i < layers - kSkins; i += 9) {
        length += LengthIn(tree.LinesAt((i + 0.5) * kStackHeight), box);
        volume += 4 * kHalf * kHalf;
      }
      EXPECT_LT(length * kPitch / volume, roofs_alone ? 0.35 : 0.7) << angle;
      EXPECT_GT(length * kPitch / volume, roofs_alone ? 0.15 : 0.5) << angle;
    }
  }
}

}  // namespace
}  // namespace slicefarm::planning::cubic_octree_test
