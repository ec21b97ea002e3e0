#include "services/planning/algo/adhesion/raft.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

#include "common/geometry/random_islands_test.h"
#include "common/geometry/text_format.h"

namespace slicefarm::planning {
namespace {

constexpr double kQuarter = std::numbers::pi / 2;

const MultiPolygon& Box20() {
  static const auto* box = new MultiPolygon(MakePolygonsOrDie("(0 0, 20 0, 20 20, 0 20)"));
  return *box;
}

double ReachMm(const MultiPolygon& region) {
  return ToMm(-static_cast<double>(Bounds(region).min.x));
}

struct Case {
  std::string name;
  RaftOptions options;
  std::vector<double> tops_mm;
  std::string kinds;  ///< i: interface, b: base
  double shift_mm;
};

// Tops and kinds as PrusaSlicer 2.5.0 printed them.
TEST(RaftUnder, IsPiledAsPrusaSlicerDoes) {
  const std::vector<Case> cases = {
      {"None", {}, {}, "", 0},
      {"One", {.layers = 1}, {0.2}, "i", 0.3},
      {"Two", {.layers = 2}, {0.2, 0.5}, "bi", 0.6},
      {"Three", {.layers = 3}, {0.2, 0.5, 0.8}, "bii", 0.9},
      {"Four", {.layers = 4}, {0.2, 0.5, 0.8, 1.1}, "bbii", 1.2},
      {"Five", {.layers = 5}, {0.2, 0.5, 0.8, 1.1, 1.4}, "bbiii", 1.5},
      {"Six", {.layers = 6}, {0.2, 0.5, 0.8, 1.1, 1.4, 1.7}, "bbbiii", 1.8},
      {"ThickFirst",
       {.layers = 3, .first_layer_height_nm = 350'000},
       {0.35, 0.65, 0.95},
       "bii",
       1.05},
      {"ThickLayers", {.layers = 3, .layer_height_nm = 350'000}, {0.2, 0.55, 0.9}, "bii", 1.0},
      {"FineLayers", {.layers = 2, .layer_height_nm = 100'000}, {0.2, 0.5}, "bi", 0.6},
      {"Nozzle", {.layers = 3, .nozzle_diameter_nm = 600'000}, {0.2, 0.65, 1.1}, "bii", 1.2},
      {"Soluble", {.layers = 3, .contact_distance_nm = 0}, {0.2, 0.5, 0.8}, "bii", 0.8},
      {"WideGap",
       {.layers = 1, .contact_distance_nm = 250'000, .first_layer_height_nm = 300'000},
       {0.3},
       "i",
       0.55},
  };
  for (const Case& c : cases) {
    const Raft raft = RaftUnder(Box20(), c.options);
    ASSERT_EQ(raft.layers.size(), c.tops_mm.size()) << c.name;
    Coord below = 0;
    for (size_t i = 0; i < raft.layers.size(); ++i) {
      const RaftLayer& layer = raft.layers[i];
      EXPECT_EQ(layer.print_z_nm, FromMm(c.tops_mm[i])) << c.name;
      EXPECT_EQ(layer.print_z_nm - layer.height_nm, below) << c.name;
      EXPECT_EQ(layer.interface, c.kinds[i] == 'i') << c.name;
      below = layer.print_z_nm;
    }
    EXPECT_EQ(raft.part_shift_nm, FromMm(c.shift_mm)) << c.name;
  }
}

struct LayerCase {
  int32_t layers;
  std::vector<double> reach_mm, density, turn;
};

TEST(RaftUnder, ReachDensityAndAngleOfEachLayer) {
  const double base = 0.4 / 2.9;
  const std::vector<LayerCase> cases = {
      {1, {1.5}, {1}, {1}},
      {2, {4.5, 1.5}, {0.9, 1}, {0, 1}},
      {3, {4.5, 2, 1.5}, {0.9, 1, 1}, {0, 1, 1}},
      {4, {4.5, 2, 2, 1.5}, {0.9, base, 1, 1}, {1, 0, 1, 1}},
      {6, {4.5, 2, 2, 2, 2, 1.5}, {0.9, base, base, 1, 1, 1}, {1, 0, 0, 1, 1, 1}},
  };
  for (const LayerCase& c : cases) {
    const Raft raft = RaftUnder(Box20(), {.layers = c.layers, .angle_rad = 0.25});
    ASSERT_EQ(raft.layers.size(), c.reach_mm.size());
    for (size_t i = 0; i < raft.layers.size(); ++i) {
      EXPECT_NEAR(ReachMm(raft.layers[i].region), c.reach_mm[i], 1e-5) << c.layers << " " << i;
      EXPECT_DOUBLE_EQ(raft.layers[i].density, c.density[i]) << c.layers << " " << i;
      EXPECT_DOUBLE_EQ(raft.layers[i].angle_rad, 0.25 + kQuarter * c.turn[i]);
    }
  }
}

TEST(RaftUnder, HolesStayWhereTheyAreWide) {
  const MultiPolygon frame = MakePolygonsOrDie("(0 0, 40 0, 40 40, 0 40) (5 5, 35 5, 35 35, 5 35)");
  const Raft raft = RaftUnder(frame, {.layers = 2});
  ASSERT_EQ(raft.layers[1].region.front().holes.size(), 1u);
  const Box hole = Bounds(raft.layers[1].region.front().holes[0]);
  EXPECT_EQ(hole.min.x, FromMm(6.5));
  EXPECT_EQ(hole.max.y, FromMm(33.5));
  const Raft closed = RaftUnder(frame, {.layers = 2, .first_layer_expansion_nm = FromMm(14)});
  EXPECT_TRUE(closed.layers[0].region.front().holes.empty());
}

TEST(RaftUnder, NothingOrCrumbs) {
  EXPECT_EQ(RaftUnder({}, {.layers = 3}), Raft{});
  EXPECT_EQ(RaftUnder(Box20(), {.layers = -1}), Raft{});
  const Raft raft = RaftUnder({{{{0, 0}, {1, 0}, {1, 1}}, {}}}, {.layers = 2});
  EXPECT_EQ(raft.part_shift_nm, FromMm(0.6));
  const Raft flush =
      RaftUnder(Box20(), {.layers = 1, .expansion_nm = 0, .first_layer_expansion_nm = 0});
  EXPECT_EQ(flush.layers[0].region, Box20());
}

TEST(RaftUnder, GrowsAsAskedOnRandomParts) {
  std::mt19937 random(9);
  for (int trial = 0; trial < 1000; ++trial) {
    const MultiPolygon part = RandomIsland(random, {}, Uniform(random, 1, 20));
    RaftOptions options{.layers = 1 + trial % 5};
    options.expansion_nm = std::llround(Uniform(random, 0, 4e6));
    options.first_layer_expansion_nm = std::llround(Uniform(random, 0, 6e6));
    const Raft raft = RaftUnder(part, options);
    for (int32_t i = 0; i < options.layers; ++i) {
      const MultiPolygon& region = raft.layers[i].region;
      double grown = static_cast<double>(options.expansion_nm);
      if (i + 1 < options.layers)
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
  for (int trial = 0; trial < 50; ++trial) {
    const MultiPolygon part = RandomIsland(random, {}, 20);
    const Raft raft = RaftUnder(part, {.layers = 3});
    EXPECT_EQ(RaftUnder(part, {.layers = 3}), raft);
    const Raft turned = RaftUnder(QuarterTurned(part), {.layers = 3});
    const Raft mirrored = RaftUnder(Mirrored(part), {.layers = 3});
    for (size_t i = 0; i < 3; ++i) {
      const double area = Area(raft.layers[i].region);
      EXPECT_NEAR(Area(turned.layers[i].region), area, area * 1e-3);
      EXPECT_NEAR(Area(mirrored.layers[i].region), area, area * 1e-3);
    }
  }
}

}  // namespace
}  // namespace slicefarm::planning
