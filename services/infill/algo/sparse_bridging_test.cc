#include "services/infill/algo/sparse_bridging.h"

#include <gtest/gtest.h>

#include "services/infill/algo/sample_sections_test.h"

namespace slicefarm::infill::sparse_bridging_test {
namespace {

using sample_sections::P;
using sample_sections::Prism;

InfillOptions Doubled() {
  InfillOptions options;
  options.top_solid_layers = 4;
  options.bottom_solid_layers = 0;
  options.internal_bridges = true;
  options.bridges.extra = ExtraBridges::kInternal;
  return options;
}

// Four solid layers begin at the layer 6 of ten. The bridge there is doubled in the layer above.
TEST(SparseBridging, SecondBridgesAreOverTheFirst) {
  const auto layers = Prism();
  const ObjectLayers objects(layers);
  const MultiPolygon none, area = P("(1 1, 19 1, 19 19, 1 19)");
  const InfillOptions options = Doubled();
  for (const int32_t layer : {6, 7, 8}) {
    SectionView view{.stack = 0,
                     .layer = layer,
                     .height_nm = 200'000,
                     .stacks = objects,
                     .above_supports = none};
    const RegionContext context(view, 0, options);
    SparseBridging bridging(context, nullptr);
    Skins skins;
    skins.solid = area;
    const auto second = bridging.TakeSecond({area}, skins);
    ASSERT_TRUE(second.ok()) << second.status();
    EXPECT_EQ(second->regions.empty(), layer != 7) << layer;
    const auto first = bridging.Take({area}, skins);
    ASSERT_TRUE(first.ok()) << first.status();
    EXPECT_EQ(first->regions.empty(), layer != 6) << layer;
  }
}

// To move the walls of the whole layer for each island would be quadratic.
TEST(SparseBridging, ManyIslandsAreFast) {
  constexpr Coord kInRow = 120;
  MultiPolygon outlines;
  for (Coord i = 0; i < kInRow * kInRow; ++i) {
    const Point low{FromMm(12) * (i % kInRow), FromMm(12) * (i / kInRow)};
    const Point high{low.x + FromMm(10), low.y + FromMm(10)};
    outlines.push_back({{low, {high.x, low.y}, high, {low.x, high.y}}, {}});
  }
  auto layers = Prism();
  for (SlicedLayer& layer : layers) layer.sections[0].regions[0].outlines = outlines;
  const ObjectLayers objects(layers);
  const MultiPolygon none;
  const InfillOptions options = Doubled();
  const SectionView view{
      .stack = 0, .layer = 4, .height_nm = 200'000, .stacks = objects, .above_supports = none};
  const RegionContext context(view, 0, options);
  SparseBridging bridging(context, nullptr);
  size_t without = 0;
  for (const PolygonWithHoles& island : outlines) {
    Skins skins;
    skins.solid = {island};
    const auto second = bridging.TakeSecond({{island}}, skins);
    ASSERT_TRUE(second.ok()) << second.status();
    without += second->regions.empty() ? 1 : 0;
  }
  EXPECT_EQ(without, outlines.size());
}

}  // namespace
}  // namespace slicefarm::infill::sparse_bridging_test
