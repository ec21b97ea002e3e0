#include "services/infill/algo/section_view.h"

#include <vector>

#include <gtest/gtest.h>

#include "common/geometry/text_format.h"

namespace slicefarm::infill::section_view_test {
namespace {

/// Five layers of a square, the fourth of which is smaller.
std::vector<SlicedLayer> Layers() {
  std::vector<SlicedLayer> layers(5);
  for (int i = 0; i < 5; ++i) {
    layers[i].frame = {i, 200'000 * (i + 1), 200'000};
    ObjectSection section;
    section.layer = i;
    section.layer_count = 5;
    section.height_nm = 200'000;
    section.regions = {{.outlines = MakePolygonsOrDie(i == 3 ? "(0 0, 9 0, 9 9, 0 9)" : "(0 0, 20 0, 20 20, 0 20)")}};
    layers[i].sections = {section};
  }
  return layers;
}

TEST(CoverOf, EqualLayersAreOnePointer) {
  const auto layers = Layers();
  const ObjectLayers stacks(layers);
  const MultiPolygon nothing;
  const SectionView view{.stack = 0, .layer = 1, .stacks = stacks, .carried = nothing};
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

}  // namespace
}  // namespace slicefarm::infill::section_view_test
