#include "services/planning/algo/adhesion/raft.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::planning::raft_test {
namespace {

const MultiPolygon& Box20() {
  static const auto* box = new MultiPolygon(MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)"));
  return *box;
}

double ReachMm(const MultiPolygon& region) {
  return ToMm(-static_cast<double>(Bounds(region).min.x));
}

struct Case {
  std::string name;
  RaftHeights heights;
  std::vector<double> tops_mm;
  std::string kinds;  ///< one letter per layer: i interface, b base, f first
  double lift_mm;
};

// Tops and kinds are from G-code of PrusaSlicer 2.5.0.
TEST(RaftUnder, IsPiledAsPrusaSlicerDoes) {
  const std::vector<Case> cases = {
      {"None", {}, {}, "", 0},
      {"One", {.layers = 1}, {0.2}, "i", 0.3},
      {"Two", {.layers = 2}, {0.2, 0.5}, "fi", 0.6},
      {"Three", {.layers = 3}, {0.2, 0.5, 0.8}, "fii", 0.9},
      {"Four", {.layers = 4}, {0.2, 0.5, 0.8, 1.1}, "fbii", 1.2},
      {"Five", {.layers = 5}, {0.2, 0.5, 0.8, 1.1, 1.4}, "fbiii", 1.5},
      {"Six", {.layers = 6}, {0.2, 0.5, 0.8, 1.1, 1.4, 1.7}, "fbbiii", 1.8},
      {"ThickFirst", {.layers = 3, .first_nm = 350'000}, {0.35, 0.65, 0.95}, "fii", 1.05},
      {"ThickLayers", {.layers = 3, .others_nm = 350'000}, {0.2, 0.55, 0.9}, "fii", 1.0},
      {"Soluble", {.layers = 3, .contact_distance_nm = 0}, {0.2, 0.5, 0.8}, "fii", 0.8},
      {"WideGap",
       {.layers = 1, .first_nm = 300'000, .contact_distance_nm = 250'000},
       {0.3},
       "i",
       0.55},
  };
  const std::map<char, RaftLayerKind> kinds = {
      {'f', RaftLayerKind::kFirst}, {'b', RaftLayerKind::kBase}, {'i', RaftLayerKind::kInterface}};
  for (const Case& c : cases) {
    const std::vector<RaftLayer> raft = RaftUnder(Box20(), {.heights = c.heights});
    ASSERT_EQ(raft.size(), c.tops_mm.size()) << c.name;
    Coord below = 0;
    for (size_t i = 0; i < raft.size(); ++i) {
      EXPECT_EQ(raft[i].print_z_nm, FromMm(c.tops_mm[i])) << c.name;
      EXPECT_EQ(raft[i].print_z_nm - raft[i].height_nm, below) << c.name;
      EXPECT_EQ(raft[i].kind, kinds.at(c.kinds[i])) << c.name;
      below = raft[i].print_z_nm;
    }
    EXPECT_EQ(c.heights.LiftNm(), FromMm(c.lift_mm)) << c.name;
  }
}

TEST(RaftUnder, ReachOfEachLayer) {
  const std::map<int32_t, std::vector<double>> reach_mm = {
      {1, {1.5}}, {2, {4.5, 1.5}}, {3, {4.5, 2, 1.5}}, {6, {4.5, 2, 2, 2, 2, 1.5}}};
  for (const auto& [layers, reach] : reach_mm) {
    const std::vector<RaftLayer> raft = RaftUnder(Box20(), {.heights = {.layers = layers}});
    ASSERT_EQ(raft.size(), reach.size());
    for (size_t i = 0; i < raft.size(); ++i)
      EXPECT_NEAR(ReachMm(raft[i].region), reach[i], 1e-5) << layers << " " << i;
  }
}

TEST(RaftUnder, HolesStayWhereTheyAreWide) {
  const MultiPolygon frame = MakePolygonsOrDie("(0 0, 40 0, 40 40, 0 40) (5 5, 35 5, 35 35, 5 35)");
  const std::vector<RaftLayer> raft = RaftUnder(frame, {.heights = {.layers = 2}});
  ASSERT_EQ(raft[1].region.front().holes.size(), 1u);
  const Box hole = Bounds(raft[1].region.front().holes[0]);
  EXPECT_EQ(hole.min.x, FromMm(6.5));
  EXPECT_EQ(hole.max.y, FromMm(33.5));
  const std::vector<RaftLayer> closed =
      RaftUnder(frame, {.heights = {.layers = 2}, .first_layer_expansion_nm = FromMm(14)});
  EXPECT_TRUE(closed[0].region.front().holes.empty());
}

TEST(RaftUnder, NothingOrCrumbs) {
  EXPECT_TRUE(RaftUnder({}, {.heights = {.layers = 3}}).empty());
  EXPECT_TRUE(RaftUnder(Box20(), {.heights = {.layers = -1}}).empty());
  EXPECT_EQ(RaftUnder({{{{0, 0}, {1, 0}, {1, 1}}, {}}}, {.heights = {.layers = 2}}).size(), 2u);
  const std::vector<RaftLayer> flush = RaftUnder(
      Box20(), {.heights = {.layers = 1}, .expansion_nm = 0, .first_layer_expansion_nm = 0});
  EXPECT_EQ(flush[0].region, Box20());
}

TEST(RaftUnder, GrowsAsAskedOnRandomParts) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 1000; ++trial) {
    const MultiPolygon part = RandomIsland(random, {}, Uniform(random, 1, 20));
    RaftOptions options{.heights = {.layers = 1 + trial % 5}};
    options.expansion_nm = std::llround(Uniform(random, 0, 4e6));
    options.first_layer_expansion_nm = std::llround(Uniform(random, 0, 6e6));
    const std::vector<RaftLayer> raft = RaftUnder(part, options);
    for (int32_t i = 0; i < options.heights.layers; ++i) {
      const MultiPolygon& region = raft[i].region;
      double grown = static_cast<double>(options.expansion_nm);
      if (i + 1 < options.heights.layers)
        grown += i == 0 ? static_cast<double>(options.first_layer_expansion_nm) : 5e5;
      ForEachBoundaryPoint(region, 2e6, [&](Point p) {
        ASSERT_NEAR(DistanceToBoundary(p, part), grown, 6'000) << trial << " " << i;
      });
      ForEachBoundaryPoint(part, 2e6, [&](Point p) { ASSERT_TRUE(Inside(p, region)); });
    }
  }
}

TEST(RaftUnder, FollowsThePart) {
  std::mt19937 random(10);
  const RaftOptions options{.heights = {.layers = 3}};
  for (int trial = 0; trial < 50; ++trial) {
    const MultiPolygon part = RandomIsland(random, {}, 20);
    const std::vector<RaftLayer> raft = RaftUnder(part, options);
    EXPECT_EQ(RaftUnder(part, options), raft);
    const std::vector<RaftLayer> turned = RaftUnder(QuarterTurned(part), options);
    const std::vector<RaftLayer> mirrored = RaftUnder(Mirrored(part), options);
    for (size_t i = 0; i < 3; ++i) {
      const double area = Area(raft[i].region);
      EXPECT_NEAR(Area(turned[i].region), area, area * 1e-3);
      EXPECT_NEAR(Area(mirrored[i].region), area, area * 1e-3);
    }
  }
}

}  // namespace
}  // namespace slicefarm::planning::raft_test
