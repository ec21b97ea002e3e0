#include "services/planning/algo/infill/surface_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "common/geometry/boolean/random_islands_test.h"
#include "services/planning/algo/infill/stacks_test.h"

namespace slicefarm::planning::surface_points_test {
namespace {

constexpr SkinLayers kSkins{1, 1};

struct Reported {
  int count = 0;
  double around_nm = 0;
};

std::map<Coord, Reported> Counts(const ObjectStack& stack, decltype(ForEachRoofPoint)& each,
                                 const SkinLayers& skins = kSkins) {
  std::map<Coord, Reported> counts;
  each(stack, skins, kNmPerMm, [&](Point, Coord z, double around) {
    ++counts[z].count;
    counts[z].around_nm = std::max(counts[z].around_nm, around);
  });
  return counts;
}

ObjectStack Step() {
  return StackOf(4, [](int i) {
    return MakePolygonsOrDie(i < 2 ? "(0 0, 20 0, 20 10, 0 10)" : "(0 0, 10 0, 10 10, 0 10)");
  });
}

TEST(SurfacePlaces, LieOnSidesAndUnderAndOverSkins) {
  const auto counts = Counts(Step(), ForEachSurfacePoint);
  // The grid is four times as fine, and the radius equals its step: roofs of the step and of the
  // top.
  EXPECT_GE(counts.at(100'000).count, 60 + 160 + 39 * 39);
  EXPECT_GE(counts.at(500'000).count, 40 + 160 + 39 * 39);
  EXPECT_NEAR(counts.at(500'000).around_nm, 302'500, 1);
  // Floor: points on the edge and on the grid.
  EXPECT_GE(counts.at(300'000).count, 60 + 60 + 19 * 9);
  EXPECT_EQ(counts.at(300'000).around_nm, 0);
  EXPECT_EQ(counts.at(700'000).count, 40);  // a point on the edge every mm
  EXPECT_EQ(counts.size(), 4u);
}

TEST(SurfacePlaces, OfThinPlatesAreTheSidesAlone) {
  const std::map<Coord, Reported> counts = Counts(Step(), ForEachSurfacePoint, {4, 4});
  ASSERT_FALSE(counts.empty());
  for (const auto& [z, reported] : counts) EXPECT_LE(reported.count, 60) << z;
}

TEST(RoofPlaces, AreNoneUnderWhatIsSteep) {
  const auto counts = Counts(Step(), ForEachRoofPoint);
  EXPECT_EQ(counts.size(), 2u);
  EXPECT_TRUE(counts.contains(100'000));
  EXPECT_TRUE(counts.contains(500'000));
  for (const bool steep : {false, true}) {
    const ObjectStack cone = StackOf(10, [&](int i) {
      const Coord half = FromMm(10) - i * (steep ? 150'000 : 250'000);
      return MultiPolygon{{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, {}}};
    });
    EXPECT_EQ(Counts(cone, ForEachRoofPoint).size(), steep ? 1u : 9u);
  }
}

TEST(InnerPlaces, AreEven) {
  std::map<Coord, int> counts;
  const ObjectStack stack = Prism(100, "(0 0, 20 0, 20 10, 0 10)");
  ForEachInnerPoint(stack, 2 * kNmPerMm, [&](Point p, Coord z) {
    EXPECT_TRUE(Inside(p, stack[0].whole) || p.x == 0 || p.y == 0);
    ++counts[z];
  });
  EXPECT_EQ(counts.size(), 10u);
  for (const auto& [z, count] : counts) EXPECT_NEAR(count, 50, 15) << z;
}

}  // namespace
}  // namespace slicefarm::planning::surface_points_test
