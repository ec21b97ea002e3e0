#include "services/infill/algo/section_view.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::section_view_test {
namespace {

/// Returns five layers of a square. The fourth layer is smaller.
std::vector<SlicedLayer> Layers() {
  std::vector<SlicedLayer> layers(5);
  for (int i = 0; i < 5; ++i) {
    layers[i].frame = {i, 200'000 * (i + 1), 200'000};
    ObjectSection section;
    section.layer = i;
    section.layer_count = 5;
    section.height_nm = 200'000;
    section.regions = {{.outlines = MakePolygonsOrDie(i == 3 ? "(0 0, 9 0, 9 9, 0 9)"
                                                             : "(0 0, 20 0, 20 20, 0 20)")}};
    layers[i].sections = {section};
  }
  return layers;
}

// A search through all islands for each of them would be quadratic.
TEST(BodyMiddles, AreFoundAmongManyIslands) {
  constexpr Coord kInRow = 250;
  auto layers = Layers();
  MultiPolygon& outlines = layers[1].sections[0].regions[0].outlines;
  outlines.clear();
  PlannedInfill plan;
  for (Coord i = 0; i < kInRow * kInRow; ++i) {
    const Point low{FromMm(2) * (i % kInRow), FromMm(2) * (i / kInRow)};
    const Point high{low.x + FromMm(1), low.y + FromMm(1)};
    outlines.push_back({{low, {high.x, low.y}, high, {low.x, high.y}}, {}});
    plan.body_middles.push_back({i, -i});
  }
  const ObjectLayers stacks(layers);
  const MultiPolygon nothing;
  const SectionView view{.stack = 0, .layer = 1, .stacks = stacks, .above_supports = nothing};
  const BodyMiddles middles(view, &plan);
  for (size_t i = 0; i < outlines.size(); ++i)
    ASSERT_EQ(middles.Of({outlines[i]}), plan.body_middles[i]);
  EXPECT_EQ(middles.Of({{{{-5, -5}, {-4, -5}, {-4, -4}}, {}}}), Point());
  EXPECT_EQ(BodyMiddles(view, nullptr).Of({outlines[7]}), Point());
}

TEST(CoverOf, EqualLayersAreOnePointer) {
  const auto layers = Layers();
  const ObjectLayers stacks(layers);
  const MultiPolygon nothing;
  const SectionView view{.stack = 0, .layer = 1, .stacks = stacks, .above_supports = nothing};
  InfillOptions options;
  options.top_solid_layers = 3;
  options.bottom_solid_layers = 2;
  const Cover cover = CoverOf(view, options, {});
  const MultiPolygon* own = view.OutlineAt(1);
  ASSERT_EQ(cover.above.size(), 3u);
  EXPECT_EQ(cover.above[0], own);
  EXPECT_NE(cover.above[1], own);
  EXPECT_EQ(cover.above[2], own);
  EXPECT_EQ(cover.below, (std::vector<const MultiPolygon*>{own, nullptr}));
  EXPECT_EQ(view.OutlineAt(7), nullptr);
}

// A first layer of 0.3 mm and two of 0.2 mm are 0.7 mm thick: a fourth layer is solid only over
// other bottoms.
TEST(CoverOf, LayersThatOnlyThicknessAsksForAreLeftOutByTheirHeights) {
  auto layers = Layers();
  layers[0].sections[0].height_nm = 300'000;
  const ObjectLayers stacks(layers);
  const MultiPolygon nothing;
  InfillOptions options;
  options.top_solid_layers = options.bottom_solid_layers = 4;
  options.top_spare = options.bottom_spare = {.layers = 2, .enough_nm = 701'000};
  const auto below = [&](int32_t layer) {
    const SectionView view{.stack = 0, .layer = layer, .stacks = stacks, .above_supports = nothing};
    return CoverOf(view, options, {}).below;
  };
  ASSERT_EQ(below(3).size(), 3u);
  EXPECT_NE(below(3).back(), nullptr) << "three lie below, which are enough";
  ASSERT_EQ(below(2).size(), 4u);
  EXPECT_EQ(below(2).back(), nullptr);
  const SectionView top{.stack = 0, .layer = 1, .stacks = stacks, .above_supports = nothing};
  EXPECT_EQ(CoverOf(top, options, {}).above.size(), 4u) << "three layers of 0.2 mm are not";
  options.top_spare.layers = 1;
  options.top_spare.enough_nm = 601'000;
  EXPECT_EQ(CoverOf(top, options, {}).above.size(), 3u);
}

}  // namespace
}  // namespace slicefarm::infill::section_view_test
