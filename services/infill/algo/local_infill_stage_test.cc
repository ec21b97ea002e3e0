#include "services/infill/algo/local_infill_stage.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numbers>
#include <set>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"
#include "common/model/options/infill_options.h"

namespace slicefarm::infill::local_infill_stage_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

ObjectSection Section(int index, int count, MultiPolygon outlines) {
  ObjectSection section{3, index, count, 200'000, {}, {}, 0, {}};
  section.regions = {{Role::kPart, 0, 0, std::move(outlines)}};
  return section;
}

/// Returns a plate of 20 mm, with only its left half from layer `step` upwards.
std::vector<SlicedLayer> Steps(int count, int step) {
  std::vector<SlicedLayer> layers(count);
  for (int i = 0; i < count; ++i) {
    layers[i].frame = {i, 200'000 * (i + 1), 200'000};
    layers[i].sections = {
        Section(i, count, P(i < step ? "(0 0, 20 0, 20 20, 0 20)" : "(0 0, 10 0, 10 20, 0 20)"))};
  }
  return layers;
}

std::vector<WalledLayer> Walled(const std::vector<SlicedLayer>& layers, LayerRange range) {
  std::vector<WalledLayer> walled;
  for (const SlicedLayer& layer : layers) {
    if (!range.Contains(layer.frame.index)) continue;
    const ObjectSection& section = layer.sections[0];
    WalledIsland island;
    island.fill_areas = {{Role::kPart, 0, 0, OutlineOf(section)}};
    for (Point& p : island.fill_areas[0].area[0].outer) {
      p.x += p.x == 0 ? 1'000'000 : -1'000'000;
      p.y += p.y == 0 ? 1'000'000 : -1'000'000;
    }
    walled.push_back(
        {layer.frame, {{section.stack, section.layer, section.height_nm, {island}}}, 0});
  }
  return walled;
}

absl::StatusOr<std::vector<FilledLayer>> Fill(const std::vector<SlicedLayer>& layers,
                                              LayerRange range, int32_t halo,
                                              const InfillOptions& options = {},
                                              CancelToken cancel = {}) {
  const auto count = static_cast<int32_t>(layers.size());
  const LayerRange seen = range.Grown(halo, count);
  StageCall call;
  call.cancel = std::move(cancel);
  const std::vector<LayerPlan> plans(static_cast<size_t>(range.size()));
  return MakeLocalInfill()->Fill(call, Walled(layers, range),
                                 {range, std::span(layers).subspan(seen.first, seen.size())}, plans,
                                 InfillTable{options});
}

std::set<Feature> FeaturesOf(const FilledLayer& layer) {
  std::set<Feature> features;
  for (const FilledIsland& island : layer.sections.at(0).islands)
    for (const FillGroup& group : island.fills)
      for (const Path& path : group.paths) features.insert(path.feature);
  return features;
}

TEST(LocalInfill, StepPartHasEveryKindOfRegion) {
  const auto filled = Fill(Steps(20, 10), {0, 20}, 5);
  ASSERT_TRUE(filled.ok()) << filled.status();
  using enum Feature;
  EXPECT_EQ(FeaturesOf((*filled)[0]), std::set{kSolidInfill});
  EXPECT_EQ(FeaturesOf((*filled)[4]), std::set{kSolidInfill});
  EXPECT_EQ(FeaturesOf((*filled)[5]), (std::set{kInternalInfill, kSolidInfill}));
  EXPECT_EQ(FeaturesOf((*filled)[9]), (std::set{kInternalInfill, kSolidInfill, kTopSolidInfill}));
  EXPECT_EQ(FeaturesOf((*filled)[12]), std::set{kInternalInfill});
  EXPECT_EQ(FeaturesOf((*filled)[19]), std::set{kTopSolidInfill});
}

TEST(LocalInfill, OverhangIsABridge) {
  std::vector<SlicedLayer> layers = Steps(20, 10);
  for (int i = 0; i < 10; ++i)
    std::swap(layers[i].sections[0].regions, layers[19 - i].sections[0].regions);
  const auto filled = Fill(layers, {0, 20}, 5);
  ASSERT_TRUE(filled.ok());
  EXPECT_TRUE(FeaturesOf((*filled)[10]).contains(Feature::kBridgeInfill));
  EXPECT_FALSE(FeaturesOf((*filled)[11]).contains(Feature::kBridgeInfill));
}

TEST(LocalInfill, SolidLinesTurnFromLayerToLayer) {
  InfillOptions options;
  options.angle_rad = 0;
  const auto filled = Fill(Steps(2, 2), {0, 2}, 5, options);
  ASSERT_TRUE(filled.ok());
  const auto line = [&](int layer) {
    return (*filled)[layer].sections[0].islands[0].fills[0].paths[0].points;
  };
  EXPECT_EQ(line(0)[0].y, line(0)[1].y);
  EXPECT_EQ(line(1)[0].x, line(1)[1].x);
}

// A slab on two legs: lines reach from leg to leg and onto the legs, at any angle of the layer.
TEST(LocalInfill, BridgesReachOntoWhatBearsThem) {
  std::vector<SlicedLayer> layers(8);
  for (int i = 0; i < 8; ++i) {
    layers[i].frame = {i, 200'000 * (i + 1), 200'000};
    layers[i].sections = {Section(i, 8, P("(0 0, 40 0, 40 20, 0 20)"))};
  }
  for (int i = 0; i < 4; ++i)
    layers[i].sections[0].regions[0].outlines =
        P("(0 0, 10 0, 10 20, 0 20) ; (30 0, 40 0, 40 20, 30 20)");
  for (const int first : {3, 4}) {  // the slab on an even layer and on an odd one
    const auto shifted = std::vector<SlicedLayer>(layers.begin() + 4 - first, layers.end());
    std::vector<SlicedLayer> numbered = shifted;
    for (size_t i = 0; i < numbered.size(); ++i)
      numbered[i].frame.index = numbered[i].sections[0].layer = static_cast<int>(i);
    std::vector<SlicedLayer> slab(numbered.begin() + first, numbered.begin() + first + 1);
    const auto walled = Walled(slab, {first, first + 1});
    const InfillOptions options;
    const auto filled = MakeLocalInfill()->Fill({}, walled, {{first, first + 1}, numbered},
                                                std::vector<LayerPlan>(1), InfillTable{options});
    ASSERT_TRUE(filled.ok()) << filled.status();
    Coord left = INT64_MAX, right = INT64_MIN;
    for (const FillGroup& group : (*filled)[0].sections[0].islands[0].fills) {
      for (const Path& path : group.paths) {
        if (path.feature != Feature::kBridgeInfill) continue;
        for (const Point p : path.points) left = std::min(left, p.x), right = std::max(right, p.x);
        EXPECT_EQ(path.points[0].y, path.points[1].y);
      }
    }
    EXPECT_LT(left, FromMm(9.4));
    EXPECT_GT(right, FromMm(30.6));
  }
}

// A slab on two walls that are as thick as its own walls: only the area under its walls supports
// it.
TEST(LocalInfill, BridgesRunFromWallToWallOverThinOnes) {
  InfillOptions options;
  options.walls_nm = FromMm(1);
  for (const int first : {3, 4}) {
    std::vector<SlicedLayer> layers(8);
    for (int i = 0; i < 8; ++i) {
      layers[i].frame = {i, 200'000 * (i + 1), 200'000};
      layers[i].sections = {Section(i, 8,
                                    i < first
                                        ? P("(0 0, 1 0, 1 30, 0 30) ; (19 0, 20 0, 20 30, 19 30)")
                                        : P("(0 0, 20 0, 20 30, 0 30)"))};
    }
    const auto filled = Fill(layers, {first, first + 1}, 5, options);
    ASSERT_TRUE(filled.ok()) << filled.status();
    int lines = 0;
    for (const FillGroup& group : (*filled)[0].sections[0].islands[0].fills)
      for (const Path& path : group.paths)
        for (size_t i = 1; i < path.points.size(); ++i) {
          const Point by = path.points[i] - path.points[i - 1];
          EXPECT_EQ(path.feature, Feature::kBridgeInfill);
          if (std::abs(by.x) + std::abs(by.y) < FromMm(1)) continue;  // link to the next line
          EXPECT_EQ(by.y, 0) << first;
          ++lines;
        }
    EXPECT_GT(lines, 50);
  }
}

TEST(LocalInfill, BridgesRunTheWayTheyAreTold) {
  std::vector<SlicedLayer> layers = Steps(20, 10);
  for (int i = 0; i < 10; ++i)
    std::swap(layers[i].sections[0].regions, layers[19 - i].sections[0].regions);
  InfillOptions options;
  options.bridge_angle_rad = std::numbers::pi / 2;
  const auto filled = Fill(layers, {10, 11}, 5, options);
  ASSERT_TRUE(filled.ok());
  int bridges = 0;
  for (const FillGroup& group : (*filled)[0].sections[0].islands[0].fills) {
    for (const Path& path : group.paths) {
      if (path.feature != Feature::kBridgeInfill) continue;
      ++bridges;
      EXPECT_EQ(path.points[0].x, path.points[1].x);
    }
  }
  EXPECT_GT(bridges, 0);
}

TEST(LocalInfill, RangesDoNotMatter) {
  const auto layers = Steps(16, 8);
  const auto all = Fill(layers, {0, 16}, 5);
  ASSERT_TRUE(all.ok());
  for (int first = 0; first < 16; first += 3) {
    const LayerRange range{first, std::min(16, first + 3)};
    const auto part = Fill(layers, range, 5);
    ASSERT_TRUE(part.ok());
    for (int i = range.first; i < range.last; ++i) EXPECT_EQ((*part)[i - first], (*all)[i]) << i;
  }
}

TEST(LocalInfill, FullDensityIsSolidThroughout) {
  InfillOptions options;
  options.density = 1;
  const auto filled = Fill(Steps(20, 10), {0, 20}, 5, options);
  ASSERT_TRUE(filled.ok());
  for (const FilledLayer& layer : *filled)
    EXPECT_FALSE(FeaturesOf(layer).contains(Feature::kInternalInfill));
}

TEST(LocalInfill, NoDensityLeavesTheInsideEmpty) {
  InfillOptions options;
  options.density = 0;
  const auto filled = Fill(Steps(20, 20), {0, 20}, 5, options);
  ASSERT_TRUE(filled.ok());
  EXPECT_TRUE((*filled)[10].sections[0].islands[0].fills.empty());
}

TEST(LocalInfill, FirstLayerHasItsOwnWidth) {
  InfillOptions options;
  options.first_layer_width_nm = 600'000;
  const auto filled = Fill(Steps(2, 2), {0, 2}, 5, options);
  ASSERT_TRUE(filled.ok());
  EXPECT_NEAR((*filled)[0].sections[0].islands[0].fills[0].paths[0].widths_nm[0], 600'000, 20'000);
  EXPECT_NEAR((*filled)[1].sections[0].islands[0].fills[0].paths[0].widths_nm[0], 450'000, 20'000);
}

// Beads this narrow for their height would overlap each other.
TEST(LocalInfill, RefusesLinesThatDoNotLieApart) {
  Coord InfillOptions::*const kOfFirst[] = {&InfillOptions::first_layer_width_nm};
  Coord InfillOptions::*const kOfOthers[] = {&InfillOptions::sparse_width_nm,
                                             &InfillOptions::solid_width_nm,
                                             &InfillOptions::top_width_nm};
  const auto refused = [](Coord InfillOptions::*width, Coord value, LayerRange range) {
    InfillOptions options;
    options.*width = value;
    return DetailOf(Fill(Steps(20, 10), range, 5, options).status()).reason ==
           Reason::kSettingOutOfRange;
  };
  for (const Coord value : {Coord{-450'000}, Coord{0}, Coord{42'920}}) {
    for (const auto width : kOfFirst) EXPECT_TRUE(refused(width, value, {0, 1})) << value;
    for (const auto width : kOfOthers) EXPECT_TRUE(refused(width, value, {9, 10})) << value;
  }
}

TEST(LocalInfill, StopsWhenCancelled) {
  int polls = 0;
  const auto filled = Fill(Steps(9, 9), {0, 9}, 5, {}, CancelToken([&] { return ++polls > 2; }));
  EXPECT_EQ(filled.status().code(), absl::StatusCode::kCancelled);
  EXPECT_EQ(polls, 3);
}

/// Fields with and without influence of other layers give the same result for any division of a
/// job.
TEST(LocalInfill, FieldsDoNotDependOnTheRange) {
  std::vector<SlicedLayer> layers = Steps(24, 12);
  for (SlicedLayer& layer : layers) layer.sections[0].z_nm = layer.frame.print_z_nm;
  std::vector<InfillOptions> cases(4);
  for (InfillOptions& options : cases) {
    options.top_solid_layers = options.bottom_solid_layers = 1;
    options.pattern = FillPattern::kRectilinear;
    options.field_halo_layers = 8;
    options.density_field = R"({"kind":"surface_distance","near":0.6,"far":0.1,"length":1.6})";
  }
  cases[1].pattern = FillPattern::kHoneycomb;
  cases[2].stress_field = R"({"kind":"constant","stress":[1,0,0.5]})";
  cases[3].density_field = R"({"kind":"voxels","count":[2,2,1],"origin":[0,0,0],)"
                           R"("spacing":[20,20,1],"values":[0.1,0.5,0.3,0.2]})";
  for (const InfillOptions& options : cases) {
    const auto whole = Fill(layers, {0, 24}, 0, options);
    ASSERT_TRUE(whole.ok()) << whole.status();
    for (const LayerRange range : {LayerRange{0, 3}, LayerRange{9, 14}, LayerRange{23, 24}}) {
      const auto part = Fill(layers, range, 8, options);
      ASSERT_TRUE(part.ok()) << part.status();
      for (int32_t i = 0; i < range.size(); ++i)
        EXPECT_EQ((*part)[static_cast<size_t>(i)], (*whole)[static_cast<size_t>(range.first + i)]);
    }
  }
}

TEST(LocalInfill, RefusesAFieldThatIsNone) {
  InfillOptions options;
  options.density_field = "{";
  const auto filled = Fill(Steps(3, 9), {0, 3}, 0, options);
  EXPECT_EQ(DetailOf(filled.status()).reason, Reason::kSettingMalformed);
}

}  // namespace
}  // namespace slicefarm::infill::local_infill_stage_test
