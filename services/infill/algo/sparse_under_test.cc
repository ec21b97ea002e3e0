#include "services/infill/algo/sparse_under.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::sparse_under_test {
namespace {

constexpr std::string_view kSquare = "(0 0, 20 0, 20 20, 0 20)";

std::vector<SlicedLayer> Layers(const std::vector<std::string_view>& outlines) {
  std::vector<SlicedLayer> layers(outlines.size());
  for (size_t i = 0; i < outlines.size(); ++i) {
    const auto index = static_cast<int32_t>(i);
    layers[i].frame = {index, 200'000 * (index + 1), 200'000};
    ObjectSection section;
    section.layer = index;
    section.layer_count = static_cast<int32_t>(outlines.size());
    section.height_nm = 200'000;
    section.z_nm = 200'000 * (index + 1);
    if (!outlines[i].empty()) section.regions = {{.outlines = MakePolygonsOrDie(outlines[i])}};
    layers[i].sections = {section};
  }
  return layers;
}

/// Under layer 4 of such layers, in a fill area of 18 x 18 mm.
SparseBelow UnderOrDie(const std::vector<std::string_view>& outlines, InfillOptions options,
                       std::string_view wanted = {}) {
  options.top_solid_layers = 2;
  options.bottom_solid_layers = 1;
  options.walls_nm = 1'000'000;
  const auto layers = Layers(outlines);
  const ObjectLayers stacks(layers);
  const MultiPolygon nothing;
  const SectionView view{
      .stack = 0, .layer = 4, .height_nm = 200'000, .stacks = stacks, .above_supports = nothing};
  const MultiPolygon fill_area = MakePolygonsOrDie("(1 1, 19 1, 19 19, 1 19)");
  SparseUnder under({.section = view, .options = options});
  SparseBelow sparse =
      under.Within(fill_area, wanted.empty() ? fill_area : MakePolygonsOrDie(wanted));
  auto beads = under.BeadsIn(sparse);
  EXPECT_TRUE(beads.ok()) << beads.status();
  sparse.beads = *std::move(beads);
  return sparse;
}

double Mm2(const MultiPolygon& region) { return Area(region) / 1e12; }

TEST(SparseUnder, AllOfAPrismWhoseTopIsTwoLayersUp) {
  const std::vector<std::string_view> prism(6, kSquare);
  const SparseBelow under = UnderOrDie(prism, {});
  EXPECT_NEAR(Mm2(under.region), 18 * 18, 1e-6);
  EXPECT_GT(Mm2(under.beads), 18 * 18 * .2);
  EXPECT_NEAR(under.pitch_nm, 5 * (450'000 - 200'000 * .2146), 1e3);
}

TEST(SparseUnder, NothingWhereTheLayerBelowIsSolid) {
  const std::vector<std::string_view> top(5, kSquare);  // two solid layers: 3 and 4
  EXPECT_TRUE(UnderOrDie(top, {}).region.empty());
  InfillOptions every;
  every.solid_every_layers = 3;
  EXPECT_TRUE(UnderOrDie(std::vector<std::string_view>(6, kSquare), every).region.empty());
}

TEST(SparseUnder, NotOverTheWallsOfASmallerLayer) {
  const std::vector<std::string_view> wider = {
      kSquare, kSquare, kSquare, "(0 0, 10 0, 10 20, 0 20)", kSquare, kSquare};
  EXPECT_NEAR(Bounds(UnderOrDie(wider, {}).region).max.x / 1e6, 9, 1e-6);
}

TEST(SparseUnder, NothingWhereWhatIsWantedIsSolid) {
  // The layer above layer 4 is missing at x > 10: layer 3 is solid there, and the skin's anchor
  // beyond.
  const std::vector<std::string_view> step = {
      kSquare, kSquare, kSquare, kSquare, "(0 0, 10 0, 10 20, 0 20)", kSquare};
  EXPECT_TRUE(UnderOrDie(step, {}, "(12 5, 15 5, 15 15, 12 15)").region.empty());
  const SparseBelow whole = UnderOrDie(step, {});
  EXPECT_GT(Mm2(whole.region), 18 * 7);
  EXPECT_EQ(UnderOrDie(step, {}, "(2 5, 5 5, 5 15, 2 15)").region, whole.region);
}

TEST(SparseUnder, LinesThatFollowNoLawAreNotKnown) {
  const std::vector<std::string_view> prism(6, kSquare);
  InfillOptions options;
  for (const FillPattern pattern : {FillPattern::kConcentric, FillPattern::kLightning}) {
    options.pattern = pattern;
    EXPECT_TRUE(UnderOrDie(prism, options).beads.empty());
  }
  options.density = 0;
  EXPECT_TRUE(UnderOrDie(prism, options).beads.empty());
}

}  // namespace
}  // namespace slicefarm::infill::sparse_under_test
