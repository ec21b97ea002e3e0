#include "services/planning/algo/supports/generator/kept_rings.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/base/portable_math.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::kept_rings_test {
namespace {

MultiPolygon Disc(double x, double y, double radius) {
  Polygon ring;
  for (int i = 0; i < 48; ++i)
    ring.push_back({FromMm(x + radius * Cos(i * std::numbers::pi / 24)),
                    FromMm(y + radius * Sin(i * std::numbers::pi / 24))});
  return {{ring, {}}};
}

/// Returns layers of branches, bottom up. The first layer is on the bed.
std::vector<SupportLayer> Layers(const std::vector<MultiPolygon>& outlines) {
  std::vector<SupportLayer> layers;
  for (size_t i = 0; i < outlines.size(); ++i)
    layers.push_back({static_cast<Coord>(i + 1) * 200'000,
                      200'000,
                      i == 0,
                      {{SupportRole::kBranch, outlines[i]}}});
  return layers;
}

const TestStack kNothing(10, [](double) { return MultiPolygon(); });

std::vector<SupportLayer> Kept(std::vector<SupportLayer> layers, int threads = 1) {
  KeepRings(kNothing.Problem(), {}, threads, CancelToken(), layers);
  return layers;
}

size_t Holes(const SupportLayer& layer) {
  size_t holes = 0;
  for (const SupportRegion& region : layer.regions)
    for (const PolygonWithHoles& island : region.outlines) holes += island.holes.size();
  return holes;
}

TEST(KeepRings, LeavesWhatIsCarried) {
  const MultiPolygon tree = Union(Disc(0, 0, 2), Disc(6, 0, 1));
  const auto layers = Layers({tree, tree, tree, tree});
  EXPECT_EQ(Kept(layers), layers);
}

TEST(KeepRings, LeavesShortSpans) {
  // Two branches that become one. Between them a loop spans a gap of about two millimetres.
  const auto layers =
      Layers({Union(Disc(0, 0, 2), Disc(3.7, 0, 2)), Union(Disc(0, 0, 2), Disc(3.8, 0, 2)),
              Union(Disc(0, 0, 1.9), Disc(3.9, 0, 1.9))});
  EXPECT_EQ(Kept(layers), layers);
}

TEST(KeepRings, CutsAHoleForALoopInside) {
  const MultiPolygon wide = Disc(0, 0, 9);
  const auto layers = Kept(Layers({wide, wide, wide, Disc(2, 1, 2)}));
  EXPECT_EQ(Holes(layers[0]), 0u) << "the first layer is filled";
  for (const size_t i : {1u, 2u}) {
    ASSERT_EQ(Holes(layers[i]), 1u) << i;
    // The loop around the hole is at the position of the branch's own loop.
    const Polygon& hole = layers[i].regions[0].outlines[0].holes[0];
    EXPECT_NEAR(-SignedArea(hole) * 1e-12, std::numbers::pi * 1.6 * 1.6, 0.15);
    EXPECT_NEAR(ToMm(Centroid(hole).x), 2, 1e-3);
  }
  EXPECT_EQ(layers[3], Layers({wide, wide, wide, Disc(2, 1, 2)})[3]);
}

TEST(KeepRings, CutsAHoleForALoopAroundAHole) {
  const MultiPolygon wide = Disc(0, 0, 9), ring = Difference(wide, Disc(1, 0, 3));
  const auto layers = Kept(Layers({wide, wide, ring}));
  ASSERT_EQ(Holes(layers[1]), 1u);
  EXPECT_NEAR(-SignedArea(layers[1].regions[0].outlines[0].holes[0]) * 1e-12, std::numbers::pi * 9,
              0.3);
}

TEST(KeepRings, ASmallBranchHasASmallHole) {
  const MultiPolygon wide = Disc(0, 0, 9);
  EXPECT_EQ(Holes(Kept(Layers({wide, wide, Disc(0, 0, 0.4)}))[1]), 1u);
}

TEST(KeepRings, LeavesRoomForTheLoopsBeside) {
  const MultiPolygon wide = Disc(0, 0, 5);
  const auto layers = Kept(Layers({wide, wide, Disc(3, 0, 1.9)}));
  ASSERT_EQ(Holes(layers[1]), 1u);
  for (const Point p : layers[1].regions[0].outlines[0].holes[0])
    EXPECT_LE(Distance(p, {0, 0}), 5e6 - 0.8e6 + 0.05e6);
}

TEST(KeepRings, SheetsAndThePartCarry) {
  const MultiPolygon wide = Disc(0, 0, 9), small = Disc(0, 0, 2);
  auto layers = Layers({wide, wide, small});
  layers[1].regions[0].role = SupportRole::kTopInterface;
  EXPECT_EQ(Kept(layers), layers);
  layers = Layers({wide, wide, wide, small});
  const TestStack plate(10, [&](double z) { return z < 0.4 ? Disc(0, 0, 3) : MultiPolygon(); });
  KeepRings(plate.Problem(), {}, 1, CancelToken(), layers);
  EXPECT_EQ(layers, Layers({wide, wide, wide, small}));
}

TEST(KeepRings, IsTheSameForAnyThreads) {
  const MultiPolygon wide = Disc(0, 0, 9), small = Union(Disc(-4, 0, 2), Disc(4, 1, 1.5));
  const auto layers = Layers({wide, wide, wide, wide, small, small});
  EXPECT_EQ(Kept(layers), Kept(layers, 3));
}

}  // namespace
}  // namespace slicefarm::planning::kept_rings_test
