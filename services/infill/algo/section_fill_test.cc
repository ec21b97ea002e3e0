#include "services/infill/algo/section_fill.h"

#include <gtest/gtest.h>

#include <set>

#include "common/geometry/text_format.h"

namespace slicefarm::infill {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

/// Ten equal layers of a square of 20 mm.
std::vector<SlicedLayer> Prism() {
  std::vector<SlicedLayer> layers(10);
  for (int i = 0; i < 10; ++i) {
    layers[i].frame = {i, 200'000 * (i + 1), 200'000};
    layers[i].sections = {{0, i, 10, 200'000,
                           {{Role::kPart, 0, 0, P("(0 0, 20 0, 20 20, 0 20)")}}, {}}};
  }
  return layers;
}

/// The section of one layer, its fill area in two halves of a row each.
WalledSection Halves(int32_t layer) {
  WalledIsland island;
  island.fill_areas = {{Role::kPart, 0, 0, P("(1 1, 10 1, 10 19, 1 19)")},
                       {Role::kPart, 1, 0, P("(10 1, 19 1, 19 19, 10 19)")}};
  return {0, layer, 200'000, {island}};
}

/// Without fields.
absl::StatusOr<FilledSection> FillPlain(WalledSection walled, bool on_bed,
                                        const ObjectLayers& objects,
                                        std::span<const InfillOptions> regions) {
  auto none = RegionFields::Read(regions, {});
  return FillSection(std::move(walled), on_bed, objects, {}, regions, *none);
}

std::set<Feature> FeaturesOf(const FilledSection& section, int32_t row) {
  std::set<Feature> features;
  for (const FilledIsland& island : section.islands)
    for (const FillGroup& group : island.fills)
      for (const Path& path : group.paths)
        if (path.settings == row) features.insert(path.feature);
  return features;
}

TEST(FillSection, EachAreaHasItsRegionsSettings) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(2);
  regions[0].top_solid_layers = regions[0].bottom_solid_layers = 1;
  regions[1].density = 1;
  const auto filled = FillPlain(Halves(5), false, objects, regions);
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(FeaturesOf(*filled, 0), std::set{Feature::kInternalInfill});
  EXPECT_EQ(FeaturesOf(*filled, 1), std::set{Feature::kSolidInfill});
}

TEST(FillSection, SkinsAreAsManyLayersAsTheRegionSays) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(2);
  regions[0].top_solid_layers = 2;
  regions[1].top_solid_layers = 4;
  regions[0].bottom_solid_layers = regions[1].bottom_solid_layers = 0;
  const auto filled = FillPlain(Halves(7), false, objects, regions);
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(FeaturesOf(*filled, 0), std::set{Feature::kInternalInfill});
  EXPECT_EQ(FeaturesOf(*filled, 1), std::set{Feature::kSolidInfill});
}

// The lowest layer of an object is its bottom, and no bridge, on a raft as on the bed.
TEST(FillSection, TheLowestLayerIsNoBridge) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  const std::vector<InfillOptions> regions(2);
  for (const bool on_bed : {true, false}) {
    const auto filled = FillPlain(Halves(0), on_bed, objects, regions);
    ASSERT_TRUE(filled.ok()) << filled.status();
    EXPECT_EQ(FeaturesOf(*filled, 0), std::set{Feature::kSolidInfill});
  }
}

TEST(FillSection, EverySoManyLayersAreSolid) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(2);
  for (InfillOptions& options : regions) options.top_solid_layers = options.bottom_solid_layers = 0;
  regions[1].solid_every_layers = 3;
  for (const int32_t layer : {5, 6, 7}) {
    const auto filled = FillPlain(Halves(layer), false, objects, regions);
    ASSERT_TRUE(filled.ok()) << filled.status();
    EXPECT_EQ(FeaturesOf(*filled, 0), std::set{Feature::kInternalInfill});
    EXPECT_EQ(FeaturesOf(*filled, 1),
              std::set{layer == 6 ? Feature::kSolidInfill : Feature::kInternalInfill});
  }
}

// Gyroids of two heights differ; layers of one height are the same whatever their number.
TEST(FillSection, PatternsSeeTheHeightInTheObject) {
  auto layers = Prism();
  for (SlicedLayer& layer : layers) layer.sections[0].z_nm = layer.frame.print_z_nm;
  layers[6].sections[0].z_nm = layers[5].sections[0].z_nm;
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(2);
  for (InfillOptions& options : regions) {
    options.top_solid_layers = options.bottom_solid_layers = 0;
    options.pattern = FillPattern::kGyroid;
  }
  const auto fills = [&](int32_t layer) {
    return FillPlain(Halves(layer), false, objects, regions)->islands[0].fills;
  };
  EXPECT_EQ(fills(5), fills(6));
  EXPECT_NE(fills(5), fills(7));
}

TEST(FillSection, AFieldTakesThePlaceOfTheDensity) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> plain(2), fields(2), dense(2);
  for (size_t i = 0; i < 2; ++i) {
    plain[i].top_solid_layers = plain[i].bottom_solid_layers = 0;
    plain[i].pattern = FillPattern::kGyroid;
    fields[i] = dense[i] = plain[i];
    plain[i].density = 0.35;
    fields[i].density_field = R"({"kind":"height","table":[[0,0.35]]})";
    dense[i].density_field = R"({"kind":"height","table":[[0,1]]})";
  }
  const auto fills = [&](const std::vector<InfillOptions>& regions) {
    auto read = RegionFields::Read(regions, layers);
    return *FillSection(Halves(5), false, objects, {}, regions, *read);
  };
  EXPECT_EQ(fills(plain), fills(fields)) << "one density for a layer is the pattern's";
  EXPECT_EQ(FeaturesOf(fills(dense), 0), std::set{Feature::kSolidInfill});
}

TEST(FillSection, ThePlateHasNoNeighbours) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  std::vector<InfillOptions> regions(1);
  regions[0].top_solid_layers = regions[0].bottom_solid_layers = 0;
  WalledIsland island;
  island.fill_areas = {{Role::kRaft, 0, 0, P("(1 1, 10 1, 10 19, 1 19)")}};
  const auto filled = FillPlain({kPlate, 0, 300'000, {island}}, true, objects, regions);
  ASSERT_TRUE(filled.ok()) << filled.status();
  EXPECT_EQ(FeaturesOf(*filled, 0), std::set{Feature::kSupport});
}

}  // namespace
}  // namespace slicefarm::infill
