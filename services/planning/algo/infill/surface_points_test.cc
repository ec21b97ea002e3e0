#include "services/planning/algo/infill/surface_points.h"

#include <gtest/gtest.h>

#include <map>

#include "services/planning/algo/infill/stacks_test.h"

namespace slicefarm::planning::surface_points_test {
namespace {

std::map<Coord, int> Counts(const ObjectStack& stack,
                            void (*each)(const ObjectStack&, Coord, const TakePoint&)) {
  std::map<Coord, int> counts;
  each(stack, kNmPerMm, [&](Point, Coord z) { ++counts[z]; });
  return counts;
}

ObjectStack Step() {
  return StackOf(4, [](int i) {
    return MakePolygonsOrDie(i < 2 ? "(0 0, 20 0, 20 10, 0 10)" : "(0 0, 10 0, 10 10, 0 10)");
  });
}

TEST(SurfacePoints, LieOnSidesTopsAndBottoms) {
  const auto counts = Counts(Step(), ForEachSurfacePoint);
  EXPECT_EQ(counts.at(100'000), 60);  // the edge, each mm
  EXPECT_EQ(counts.at(300'000), 60);
  EXPECT_EQ(counts.at(500'000), 40);
  EXPECT_GE(counts.at(0), 60 + 19 * 9);       // the bottom: edge and grid
  EXPECT_GE(counts.at(400'000), 40 + 9 * 9);  // the step
  EXPECT_GE(counts.at(800'000), 40 + 9 * 9);  // the top
  EXPECT_FALSE(counts.contains(200'000));
}

TEST(SurfacePoints, TopsThatAreSteepAreNone) {
  const auto counts = Counts(Step(), ForEachTopPoint);
  EXPECT_EQ(counts.size(), 2u);
  EXPECT_TRUE(counts.contains(400'000));
  EXPECT_TRUE(counts.contains(800'000));
  for (const bool steep : {false, true}) {
    const ObjectStack cone = StackOf(10, [&](int i) {
      const Coord half = FromMm(10) - i * (steep ? 150'000 : 250'000);
      return MultiPolygon{{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, {}}};
    });
    EXPECT_EQ(Counts(cone, ForEachTopPoint).size(), steep ? 1u : 10u);
  }
}

}  // namespace
}  // namespace slicefarm::planning::surface_points_test
