#include "services/beading/algo/local_beading_stage.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"
#include "common/model/options/beading_options.h"

namespace slicefarm::beading::local_beading_stage_test {
namespace {

/// Returns the layers of one object with one region.
std::vector<SlicedLayer> Layers(const std::vector<MultiPolygon>& outlines) {
  std::vector<SlicedLayer> layers(outlines.size());
  for (size_t i = 0; i < outlines.size(); ++i) {
    const auto index = static_cast<int32_t>(i);
    layers[i].frame = {index, 200'000 * (index + 1), 200'000};
    ObjectSection section{7, index, static_cast<int32_t>(outlines.size()), 200'000, {}, {}, 0, {}};
    if (!outlines[i].empty()) section.regions = {{Role::kPart, 0, 0, outlines[i]}};
    layers[i].sections.push_back(std::move(section));
  }
  return layers;
}

std::vector<SlicedLayer> Layers(int count, std::string_view outlines) {
  return Layers(std::vector<MultiPolygon>(static_cast<size_t>(count), MakePolygonsOrDie(outlines)));
}

absl::StatusOr<std::vector<WalledLayer>> Bead(std::span<const SlicedLayer> layers, LayerRange range,
                                              const BeadingOptions& options = {},
                                              CancelToken cancel = {}) {
  StageCall call;
  call.cancel = std::move(cancel);
  return MakeLocalBeading()->Bead(call, {range, layers}, BeadingTable{options});
}

BeadingOptions Classic() {
  BeadingOptions options;
  options.generator = WallGenerator::kClassic;
  return options;
}

constexpr std::string_view kTwoIslands =
    "(0 0, 20 0, 20 20, 0 20) (8 8, 12 8, 12 12, 8 12) ; (30 0, 40 0, 40 0.4, 30 0.4)";

TEST(LocalBeading, PathsSayWhatTheyAre) {
  const auto walled = Bead(Layers(2, kTwoIslands), {1, 2}, Classic());
  ASSERT_TRUE(walled.ok()) << walled.status();
  ASSERT_EQ(walled->size(), 1u);
  EXPECT_EQ((*walled)[0].frame.index, 1);
  ASSERT_EQ((*walled)[0].sections[0].islands.size(), 2u);
  const WalledIsland& square = (*walled)[0].sections[0].islands[0];
  EXPECT_EQ(square.walls.size(), 6u);  // three insets of an outline and a hole
  for (const Path& path : square.walls) {
    EXPECT_EQ(path.feature, path.inset == 0 ? Feature::kExternalPerimeter : Feature::kPerimeter);
    EXPECT_TRUE(path.closed);
    EXPECT_EQ(path.widths_nm, std::vector<Coord>{450'000});
  }
  const WalledIsland& blade = (*walled)[0].sections[0].islands[1];
  ASSERT_EQ(blade.walls.size(), 1u);
  EXPECT_EQ(blade.walls[0].feature, Feature::kGapFill);
  EXPECT_TRUE(blade.fill_areas.empty());
}

TEST(LocalBeading, ABladeIsAWallOfItsWidth) {
  const auto walled = Bead(Layers(2, kTwoIslands), {1, 2});
  ASSERT_TRUE(walled.ok()) << walled.status();
  ASSERT_EQ((*walled)[0].sections[0].islands.size(), 2u);
  EXPECT_EQ((*walled)[0].sections[0].islands[0].walls.size(), 6u);
  const WalledIsland& blade = (*walled)[0].sections[0].islands[1];
  ASSERT_EQ(blade.walls.size(), 1u);
  EXPECT_EQ(blade.walls[0].feature, Feature::kExternalPerimeter);
  EXPECT_FALSE(blade.walls[0].closed);
  EXPECT_EQ(blade.walls[0].widths_nm, std::vector<Coord>{400'000});
  EXPECT_EQ((*walled)[0].plain_islands, 0);
}

TEST(LocalBeading, FirstLayerHasItsOwnWidth) {
  BeadingOptions options;
  options.first_layer_width_nm = 600'000;
  const auto walled = Bead(Layers(2, kTwoIslands), {0, 2}, options);
  ASSERT_TRUE(walled.ok());
  EXPECT_EQ((*walled)[0].sections[0].islands[0].walls[0].widths_nm[0], 600'000);
  EXPECT_EQ((*walled)[1].sections[0].islands[0].walls[0].widths_nm[0], 450'000);
}

/// Returns strips with a width that varies from layer to layer around the limit for one more bead.
/// Adjacent layers must decide it together.
std::vector<SlicedLayer> Strips(int count) {
  std::vector<MultiPolygon> outlines;
  for (int i = 0; i < count; ++i) {
    MultiPolygon strips;
    for (Coord k = 0; k < 20; ++k) {
      const Coord half = 400'000 + 20'000 * k + (i % 2 == 0 ? 15'000 : -15'000);
      const Coord y = 5'000'000 * k;
      strips.push_back(
          {{{0, y - half}, {20'000'000, y - half}, {20'000'000, y + half}, {0, y + half}}, {}});
    }
    outlines.push_back(std::move(strips));
  }
  return Layers(outlines);
}

// Each range is cut out with its halo, like the ranges of a job, and contains nothing else.
TEST(LocalBeading, RangesDoNotMatter) {
  const auto layers = Strips(12);
  const auto all = Bead(layers, {0, 12});
  ASSERT_TRUE(all.ok()) << all.status();
  for (const int size : {1, 2, 5}) {
    for (int first = 0; first < 12; first += size) {
      const LayerRange range{first, std::min(12, first + size)};
      const LayerRange seen = range.Grown(kBeadingHaloLayers, 12);
      const auto part = Bead(std::span(layers).subspan(static_cast<size_t>(seen.first),
                                                       static_cast<size_t>(seen.size())),
                             range);
      ASSERT_TRUE(part.ok());
      for (int i = range.first; i < range.last; ++i)
        EXPECT_EQ((*part)[static_cast<size_t>(i - first)], (*all)[static_cast<size_t>(i)]) << i;
    }
  }
}

// The previous test could not detect that the neighbours make no difference; this one does.
TEST(LocalBeading, WallsLookAtTheLayersAround) {
  const auto layers = Strips(12);
  const auto all = Bead(layers, {0, 12});
  int others = 0;
  for (int i = 0; i < 12; ++i) {
    const auto alone = Bead(std::span(layers).subspan(static_cast<size_t>(i), 1), {i, i + 1});
    ASSERT_TRUE(alone.ok());
    others += (*alone)[0] == (*all)[static_cast<size_t>(i)] ? 0 : 1;
  }
  EXPECT_GT(others, 0);
}

TEST(LocalBeading, StacksOfOneObjectDoNotLookAtEachOther) {
  const std::vector<SlicedLayer> parts = Strips(12);
  std::vector<SlicedLayer> both = parts;
  for (size_t i = 0; i < both.size(); ++i) {
    both[i].sections.push_back(parts[parts.size() - 1 - i].sections[0]);
    both[i].sections.back().stack = Stack(5, 0, StackKind::kSupport);
    both[i].sections.back().layer = static_cast<int32_t>(i);
  }
  const auto alone = Bead(parts, {0, 12});
  const auto beside = Bead(both, {0, 12});
  ASSERT_TRUE(beside.ok()) << beside.status();
  for (size_t i = 0; i < both.size(); ++i)
    EXPECT_EQ((*beside)[i].sections[0], (*alone)[i].sections[0]) << i;
}

TEST(LocalBeading, EmptyLayersStayEmpty) {
  const auto walled = Bead(Layers(1, ""), {0, 1});
  ASSERT_TRUE(walled.ok());
  EXPECT_TRUE((*walled)[0].sections[0].islands.empty());
}

TEST(LocalBeading, StopsWhenCancelled) {
  int polls = 0;
  const auto walled =
      Bead(Layers(5, kTwoIslands), {0, 5}, {}, CancelToken([&] { return ++polls > 2; }));
  EXPECT_EQ(walled.status().code(), absl::StatusCode::kCancelled);
  EXPECT_EQ(polls, 3);
}

TEST(LocalBeading, RefusesBeadsWithoutSpacing) {
  BeadingOptions options;
  options.inner_width_nm = 40'000;
  const auto walled = Bead(Layers(2, kTwoIslands), {0, 2}, options);
  EXPECT_EQ(DetailOf(walled.status()).reason, Reason::kSettingOutOfRange);
}

}  // namespace
}  // namespace slicefarm::beading::local_beading_stage_test
