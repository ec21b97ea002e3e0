#include "services/infill/algo/bridge_fill.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "services/infill/algo/sample_sections_test.h"

namespace slicefarm::infill::bridge_fill_test {
namespace {

using sample_sections::BridgeBy;
using sample_sections::FeaturesOf;
using sample_sections::FillPlain;
using sample_sections::LengthOf;
using sample_sections::OneLayer;
using sample_sections::P;
using sample_sections::PathsIn;
using sample_sections::PathsOf;
using sample_sections::Prism;
using sample_sections::Thin;
using sample_sections::VolumeOf;

/// Returns the directions of a feature's straight lines in degrees, in [0, 180), by length: the
/// direction with the longest edges.
double DirectionOf(const FilledSection& section, Feature feature) {
  double longest = 0, direction = -1;
  for (const Path& path : PathsOf(section)) {
    if (path.feature != feature) continue;
    for (size_t i = 1; i < path.points.size(); ++i) {
      const Point along = path.points[i] - path.points[i - 1];
      if (Norm(along) <= longest) continue;
      longest = Norm(along);
      const double degrees =
          std::atan2(static_cast<double>(along.y), static_cast<double>(along.x)) * 180 /
          std::numbers::pi;
      direction = std::fmod(degrees + 360, 180);
    }
  }
  return direction;
}

constexpr double kDegree = std::numbers::pi / 180;

// The direction of a surface is the same in all layers; other solid infill turns.
TEST(FillSection, SurfacesHaveTheirDirection) {
  InfillOptions options;
  options.surfaces.top_angle_rad = 20 * kDegree;
  options.surfaces.bottom_angle_rad = 70 * kDegree;
  EXPECT_NEAR(DirectionOf(OneLayer(options, 9), Feature::kTopSolidInfill), 20, 0.1);
  EXPECT_NEAR(DirectionOf(OneLayer(options, 0), Feature::kSolidInfill), 70, 0.1);
  EXPECT_NEAR(DirectionOf(OneLayer(options, 8), Feature::kSolidInfill), 45, 0.1);
  EXPECT_NEAR(DirectionOf(OneLayer(options, 7), Feature::kSolidInfill), 135, 0.1);
}

// Copies that are turned by 10 degrees have all directions turned.
TEST(FillSection, DirectionsTurnWithTheModel) {
  InfillOptions options;
  options.top_solid_layers = 3;
  options.bottom_solid_layers = 1;
  options.pattern = FillPattern::kAlignedRectilinear;
  const auto directions = [&] {
    InfillOptions given = options;
    given.surfaces.top_angle_rad = 20 * kDegree;
    InfillOptions bridge = Thin();
    bridge.turn_rad = options.turn_rad;
    bridge.bridge_angle_rad = 30 * kDegree;
    return std::vector{DirectionOf(OneLayer(options, 5), Feature::kInternalInfill),
                       DirectionOf(OneLayer(options, 8), Feature::kSolidInfill),
                       DirectionOf(OneLayer(given, 9), Feature::kTopSolidInfill),
                       DirectionOf(BridgeBy(bridge), Feature::kBridgeInfill)};
  };
  const auto before = directions();
  options.turn_rad = 10 * kDegree;
  const auto after = directions();
  for (size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i] + 10, 0.1) << i;
}

TEST(BridgeFill, BridgeAnglesAreAbsoluteOrRelative) {
  InfillOptions options = Thin();
  options.bridge_angle_rad = 8 * kDegree;
  EXPECT_NEAR(DirectionOf(BridgeBy(options), Feature::kBridgeInfill), 8, 0.1);
  options.bridges.relative = true;
  const double best = DirectionOf(BridgeBy(Thin()), Feature::kBridgeInfill);
  EXPECT_NEAR(DirectionOf(BridgeBy(options), Feature::kBridgeInfill), std::fmod(best + 8, 180),
              0.1);
}

TEST(BridgeFill, BridgesOverSparseInfillHaveTheirDirection) {
  InfillOptions options;
  options.top_solid_layers = 3;
  options.bottom_solid_layers = 0;
  options.pattern = FillPattern::kAlignedRectilinear;
  const auto direction = [&] { return DirectionOf(OneLayer(options, 7), Feature::kBridgeInfill); };
  const double best = direction();
  options.bridges.internal_angle_rad = 60 * kDegree;
  EXPECT_NEAR(direction(), 60, 0.1);
  options.bridges.relative = true;
  EXPECT_NEAR(direction(), std::fmod(best + 60, 180), 0.1);
}

// The strands of a bridge have the diameter of the setting, and flat lines its width.
TEST(BridgeFill, BridgesHaveTheirWidth) {
  for (const bool thick : {true, false}) {
    InfillOptions options = Thin();
    options.thick_bridges = thick;
    options.bridges.width_nm = 300'000;
    const auto lengths = [&] { return LengthOf(BridgeBy(options), Feature::kBridgeInfill); };
    const double thin = lengths();
    options.bridges.width_nm = 600'000;
    const double distance_ratio = thick ? 0.35 / 0.65 : 0.257 / 0.557;
    EXPECT_NEAR(lengths() / thin, distance_ratio, 0.03) << thick;
  }
}

// The layer above a bridge over air is a bridge with parallel, flat lines.
TEST(BridgeFill, BridgesOverAirHaveASecondLayerIfAskedFor) {
  InfillOptions options = Thin();
  options.density = 1;
  const auto features = [&](int32_t layer) { return FeaturesOf(BridgeBy(options, layer), 0); };
  for (const ExtraBridges extra : {ExtraBridges::kNone, ExtraBridges::kInternal}) {
    options.bridges.extra = extra;
    EXPECT_EQ(features(6), std::set{Feature::kSolidInfill});
  }
  for (const ExtraBridges extra : {ExtraBridges::kExternal, ExtraBridges::kAll}) {
    options.bridges.extra = extra;
    EXPECT_EQ(features(6), (std::set{Feature::kBridgeInfill, Feature::kSolidInfill}));
    EXPECT_EQ(features(7), std::set{Feature::kSolidInfill});
    EXPECT_EQ(DirectionOf(BridgeBy(options, 6), Feature::kBridgeInfill),
              DirectionOf(BridgeBy(options, 5), Feature::kBridgeInfill));
  }
  for (const FillStats& use : BridgeBy(options, 6).uses)
    EXPECT_NEAR(use.asked_mm3 / use.volume_mm3, 1, 1e-6);
}

/// Returns the direction of the second bridge if the layer above the slab has only this area.
double SecondDirection(std::string_view above) {
  InfillOptions options = Thin();
  options.density = 1;
  options.bridges.extra = ExtraBridges::kExternal;
  auto layers = Prism();
  for (size_t i = 0; i < layers.size(); ++i) {
    MultiPolygon& outlines = layers[i].sections[0].regions[0].outlines;
    if (i < 5) outlines = P("(0 0, 5 0, 5 20, 0 20) ; (15 0, 20 0, 20 20, 15 20)");
    if (i > 5) outlines = P(above);
  }
  const ObjectLayers objects(layers);
  WalledIsland island;
  island.fill_areas = {{Role::kPart, 0, 0, P(above)}};
  const std::vector<InfillOptions> regions = {options};
  const auto rows = ParseFields(regions);
  RegionFields none(*rows, {});
  const auto filled = FillSection({0, 6, 200'000, {island}}, false, objects, {}, regions, none);
  EXPECT_TRUE(filled.ok()) << filled.status();
  return DirectionOf(*filled, Feature::kBridgeInfill);
}

// A column on a bridge does not reach the bridge's pillars, or only one of them.
TEST(BridgeFill, SecondLayersAreParallelToTheBridgeThatBearsThem) {
  const double first = DirectionOf(BridgeBy(Thin()), Feature::kBridgeInfill);
  EXPECT_NEAR(SecondDirection("(8 6, 12 6, 12 14, 8 14)"), first, 0.1);
  EXPECT_NEAR(SecondDirection("(2 8, 10 8, 10 10, 2 10)"), first, 0.1);
  EXPECT_NEAR(SecondDirection("(1 1, 19 1, 19 19, 1 19)"), first, 0.1);
}

// The layer above a bridge over sparse infill is a bridge with lines across.
TEST(BridgeFill, BridgesOverSparseInfillHaveASecondLayerIfAskedFor) {
  InfillOptions options;
  options.top_solid_layers = 4;
  options.bottom_solid_layers = 0;
  options.internal_bridges = true;
  const auto features = [&](int32_t layer) { return FeaturesOf(OneLayer(options, layer), 0); };
  ASSERT_EQ(features(6), std::set{Feature::kInternalBridge});
  for (const ExtraBridges extra : {ExtraBridges::kNone, ExtraBridges::kExternal}) {
    options.bridges.extra = extra;
    EXPECT_EQ(features(7), std::set{Feature::kSolidInfill});
  }
  options.bridges.extra = ExtraBridges::kInternal;
  EXPECT_TRUE(features(7).contains(Feature::kInternalBridge));
  EXPECT_FALSE(features(8).contains(Feature::kInternalBridge));
  const double first = DirectionOf(OneLayer(options, 6), Feature::kInternalBridge);
  const double second = DirectionOf(OneLayer(options, 7), Feature::kInternalBridge);
  EXPECT_NEAR(std::abs(first - second), 90, 0.1);
  const double area = LengthOf(OneLayer(options, 7), Feature::kInternalBridge);
  EXPECT_GT(area, 0.9 * 18 * 18 / .45);
}

// Solid infill inside the object is less dense in the second layer, and dense again after the
// layers of the compensation.
TEST(FillSection, SolidInfillNearTheBedIsLessDense) {
  InfillOptions options;
  options.density = 1;
  options.top_solid_layers = 1;
  const auto plastic = [&](int32_t layer) {
    return VolumeOf(PathsIn(OneLayer(options, layer)), Feature::kSolidInfill);
  };
  const double full = plastic(1), bed = plastic(0);
  options.solid.foot_density = 0.7;
  options.solid.foot_layers = 3;
  EXPECT_EQ(plastic(0), bed);
  for (const auto& [layer, share] :
       {std::pair(1, 0.7), std::pair(2, 0.8), std::pair(3, 0.9), std::pair(4, 1.0)})
    EXPECT_NEAR(plastic(layer) / full, share, 0.02) << layer;
}

// The top surface of a plane continues under a feature on it.
TEST(FillSection, TopSurfacesGrowUnderFeatures) {
  auto layers = Prism();
  for (size_t i = 6; i < 10; ++i)
    layers[i].sections[0].regions[0].outlines = P("(7 7, 13 7, 13 13, 7 13)");
  const ObjectLayers objects(layers);
  WalledIsland island;
  island.fill_areas = {{Role::kPart, 0, 0, P("(1 1, 19 1, 19 19, 1 19)")}};
  InfillOptions options;
  options.walls_nm = 1'000'000;
  options.top_solid_layers = 2;
  options.bottom_solid_layers = 1;
  const auto plastic = [&](int32_t layer, Feature feature) {
    return VolumeOf(PathsIn(*FillPlain({0, layer, 200'000, {island}}, false, objects, {options})),
                    feature);
  };
  const double top = plastic(5, Feature::kTopSolidInfill);
  options.surfaces.expansion_nm = 4'000'000;
  EXPECT_NEAR(plastic(5, Feature::kTopSolidInfill) - top, 36 * 0.2, 0.4);
  // The layer below is solid, so that the surface does not lie on sparse infill.
  EXPECT_EQ(plastic(4, Feature::kInternalInfill), 0);
  EXPECT_EQ(plastic(4, Feature::kTopSolidInfill), 0);
}

}  // namespace
}  // namespace slicefarm::infill::bridge_fill_test
