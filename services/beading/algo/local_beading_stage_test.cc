#include "services/beading/algo/local_beading_stage.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format.h"
#include "common/base/error.h"

namespace slicefarm::beading {
namespace {

std::vector<SlicedLayer> Layers(int count, std::string_view outlines) {
  std::vector<SlicedLayer> layers(count);
  for (int i = 0; i < count; ++i) {
    layers[i].frame = {i, 200'000 * (i + 1), 200'000};
    layers[i].objects.push_back({7, MakePolygonsOrDie(outlines)});
  }
  return layers;
}

absl::StatusOr<std::vector<WalledLayer>> Bead(const std::vector<SlicedLayer>& layers,
                                              LayerRange range, const BeadingOptions& options = {},
                                              CancelToken cancel = {}) {
  StageCall call;
  call.cancel = std::move(cancel);
  return MakeLocalBeading()->Bead(call, {range, static_cast<int32_t>(layers.size()), layers},
                                  options);
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
  ASSERT_EQ((*walled)[0].islands.size(), 2u);
  const WalledIsland& square = (*walled)[0].islands[0];
  EXPECT_EQ(square.walls.size(), 6u);  // three insets of an outline and a hole
  for (const Path& path : square.walls) {
    EXPECT_EQ(path.feature, path.inset == 0 ? Feature::kExternalPerimeter : Feature::kPerimeter);
    EXPECT_TRUE(path.closed);
    EXPECT_EQ(path.object, 7);
    EXPECT_EQ(path.widths_nm, std::vector<Coord>{450'000});
  }
  const WalledIsland& blade = (*walled)[0].islands[1];
  ASSERT_EQ(blade.walls.size(), 1u);
  EXPECT_EQ(blade.walls[0].feature, Feature::kGapFill);
  EXPECT_EQ(blade.walls[0].object, 7);
  EXPECT_TRUE(blade.fill_area.empty());
}

TEST(LocalBeading, ABladeIsAWallOfItsWidth) {
  const auto walled = Bead(Layers(2, kTwoIslands), {1, 2});
  ASSERT_TRUE(walled.ok()) << walled.status();
  ASSERT_EQ((*walled)[0].islands.size(), 2u);
  EXPECT_EQ((*walled)[0].islands[0].walls.size(), 6u);
  const WalledIsland& blade = (*walled)[0].islands[1];
  ASSERT_EQ(blade.walls.size(), 1u);
  EXPECT_EQ(blade.walls[0].feature, Feature::kExternalPerimeter);
  EXPECT_FALSE(blade.walls[0].closed);
  EXPECT_EQ(blade.walls[0].object, 7);
  EXPECT_EQ(blade.walls[0].widths_nm, std::vector<Coord>{400'000});
  EXPECT_EQ((*walled)[0].frame.plain_islands, 0);
}

TEST(LocalBeading, FirstLayerHasItsOwnWidth) {
  BeadingOptions options;
  options.first_layer_width_nm = 600'000;
  const auto walled = Bead(Layers(2, kTwoIslands), {0, 2}, options);
  ASSERT_TRUE(walled.ok());
  EXPECT_EQ((*walled)[0].islands[0].walls[0].widths_nm[0], 600'000);
  EXPECT_EQ((*walled)[1].islands[0].walls[0].widths_nm[0], 450'000);
}

TEST(LocalBeading, RangesDoNotMatter) {
  const auto layers = Layers(5, kTwoIslands);
  const auto all = Bead(layers, {0, 5});
  ASSERT_TRUE(all.ok());
  for (int i = 0; i < 5; ++i) {
    const auto one = Bead(layers, {i, i + 1});
    ASSERT_TRUE(one.ok());
    EXPECT_EQ((*one)[0], (*all)[i]);
  }
}

TEST(LocalBeading, EmptyLayersStayEmpty) {
  const auto walled = Bead(Layers(1, ""), {0, 1});
  ASSERT_TRUE(walled.ok());
  EXPECT_TRUE((*walled)[0].islands.empty());
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
}  // namespace slicefarm::beading
