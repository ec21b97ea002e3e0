#include "services/exposure/algo/scan/deep_outlines.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::deep_outlines_test {
namespace {

/// Returns the layers of one object, beginning with the lowest. "" is an empty layer.
std::vector<SlicedLayer> Tower(const std::vector<const char*>& outlines) {
  std::vector<SlicedLayer> layers(outlines.size());
  for (size_t i = 0; i < outlines.size(); ++i) {
    const auto index = static_cast<int32_t>(i);
    layers[i].frame = {index, (index + 1) * 50'000, 50'000};
    ObjectSection& section = layers[i].sections.emplace_back();
    section.layer = index;
    section.layer_count = static_cast<int32_t>(outlines.size());
    if (*outlines[i] == '\0') continue;
    section.regions.push_back({.outlines = MakePolygonsOrDie(outlines[i])});
  }
  return layers;
}

double Mm2(const MultiPolygon* region) { return region == nullptr ? -1 : Area(*region) / 1e12; }

constexpr const char kLeg[] = "(0 0, 2 0, 2 10, 0 10)";
constexpr const char kTable[] = "(0 0, 10 0, 10 10, 0 10)";

TEST(DeepOutlines, WhatHangsOverPowderWaitsForDepthLayers) {
  const std::vector<SlicedLayer> layers = Tower({kLeg, kLeg, kLeg, kTable, kTable, kTable});
  const ObjectLayers objects(layers);
  const double kAreas[][6] = {
      {20, 20, 20, 100, 100, 100}, {20, 20, 20, 20, 100, 100}, {20, 20, 20, 20, 20, 100}};
  for (int32_t depth = 0; depth < 3; ++depth) {
    DeepOutlines deep(objects, depth);
    for (int32_t layer = 0; layer < 6; ++layer)
      EXPECT_NEAR(Mm2(deep.Find(0, layer)), kAreas[depth][layer], 1e-6) << depth << " " << layer;
    EXPECT_EQ(deep.Find(0, 6), nullptr);
    EXPECT_EQ(deep.Find(1, 0), nullptr);
  }
}

TEST(DeepOutlines, OverAGapThereIsNone) {
  const std::vector<SlicedLayer> layers = Tower({kTable, kTable, "", kTable, kTable});
  const ObjectLayers objects(layers);
  DeepOutlines deep(objects, 1);
  EXPECT_NEAR(Mm2(deep.Find(0, 1)), 100, 1e-6);
  EXPECT_NEAR(Mm2(deep.Find(0, 3)), 0, 1e-6);
  EXPECT_NEAR(Mm2(deep.Find(0, 4)), 100, 1e-6);
}

TEST(DeepOutlines, OfARegionIsItsPartOfTheWhole) {
  const std::vector<SlicedLayer> layers = Tower({kLeg, kTable});
  const ObjectLayers objects(layers);
  const DeepOutlines deep(objects, 1);
  const MultiPolygon half = MakePolygonsOrDie("(0 5, 10 5, 10 10, 0 10)");
  EXPECT_NEAR(Area(deep.Of(layers[1].sections[0], half)) / 1e12, 10, 1e-6);
  EXPECT_EQ(deep.Of(layers[0].sections[0], half), half);
}

}  // namespace
}  // namespace slicefarm::exposure::deep_outlines_test
