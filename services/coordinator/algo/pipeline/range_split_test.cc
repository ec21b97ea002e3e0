#include "services/coordinator/algo/pipeline/range_split.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::coordinator::range_split_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<SlicedLayer> Layers(int count, int points = 4) {
  Polygon ring(points);
  for (int i = 0; i < points; ++i) ring[i] = {i, Coord{i} * i};
  std::vector<SlicedLayer> layers(count);
  for (int i = 0; i < count; ++i) {
    layers[i].frame.index = i;
    ObjectSection section;
    section.regions = {{.outlines = {{ring, {}}}}};
    layers[i].sections = {section};
  }
  return layers;
}

std::vector<int> Sizes(const std::vector<LayerRange>& ranges) {
  std::vector<int> sizes;
  for (const LayerRange& range : ranges) sizes.push_back(range.size());
  return sizes;
}

struct Case {
  std::string name;
  int layers;
  int points;
  int slots;
  std::vector<int> want;
};

class SplitTest : public testing::TestWithParam<Case> {};

TEST_P(SplitTest, GivesTheseSizes) {
  const Case& c = GetParam();
  EXPECT_EQ(Sizes(SplitIntoRanges(Layers(c.layers, c.points), c.slots)), c.want);
}

INSTANTIATE_TEST_SUITE_P(
    Split, SplitTest,
    testing::Values(Case{"None", 0, 4, 2, {}}, Case{"One", 1, 4, 2, {1}},
                    Case{"FewLayers", 10, 4, 8, {8, 2}},
                    Case{"Shrinking", 64, 4, 2, {16, 12, 9, 8, 8, 8, 3}},
                    Case{"Capped", 600, 4, 1, {128, 128, 128, 108, 54, 27, 13, 8, 6}},
                    Case{"NoSlotsYet", 32, 4, 0, {8, 8, 8, 8}},
                    Case{"HugeLayersGoAlone", 3, 200'000, 1, {1, 1, 1}}),
    [](const auto& info) { return info.param.name; });

TEST(SplitIntoRanges, ComplexLayersMakeShorterRanges) {
  auto layers = Layers(32, 2000);
  const auto tail = Layers(32, 4);
  layers.insert(layers.end(), tail.begin(), tail.end());
  const auto ranges = SplitIntoRanges(layers, 1);
  EXPECT_LT(ranges.front().size(), 32);
}

TEST(SplitIntoRanges, LayersThatEachHaveALongTextMakeShorterRanges) {
  const auto layers = Layers(600);
  for (const auto& [layer_points, most] : {std::pair{100, 128}, {1'500, 66}, {20'000, 5}}) {
    const auto sizes = Sizes(SplitIntoRanges(layers, 1, {.layer_points = layer_points}));
    EXPECT_EQ(*std::ranges::max_element(sizes), most) << layer_points;
  }
}

TEST(CheckNeighbourhoods, RangesAreBoundedWithWhatTheyLookAt) {
  auto layers = Layers(100, 50);
  for (int32_t i = 0; i < 100; ++i) {
    layers[i].sections[0].layer = i;
    layers[i].sections[0].layer_count = 100;
  }
  const std::vector<LayerRange> ranges = {{0, 10}, {10, 100}};
  EXPECT_TRUE(CheckNeighbourhoods(layers, ranges, 0, 4'500).ok());
  EXPECT_TRUE(CheckNeighbourhoods(layers, ranges, 5, 4'750).ok());
  const ErrorDetail refused = DetailOf(CheckNeighbourhoods(layers, ranges, 1'000, 4'999));
  EXPECT_EQ(refused.reason, Reason::kRequestTooLarge);
  EXPECT_EQ(refused.metadata.at("limit"), "4999");
  EXPECT_EQ(refused.metadata.at("got"), "5000");
  EXPECT_TRUE(CheckNeighbourhoods(layers, ranges, 1'000, 5'000).ok());
  EXPECT_TRUE(CheckNeighbourhoods({}, {}, 5, 0).ok());
}

TEST(SplitIntoRanges, CoversAllLayersOnce) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<SlicedLayer> layers;
    for (int i = 0, n = random() % 300; i < n; ++i) {
      layers.push_back(Layers(1, 1 + random() % 5000)[0]);
    }
    int next = 0;
    for (const LayerRange& range : SplitIntoRanges(layers, random() % 20)) {
      EXPECT_EQ(range.first, next);
      EXPECT_GT(range.last, range.first);
      next = range.last;
    }
    EXPECT_EQ(next, static_cast<int>(layers.size()));
  }
}

}  // namespace
}  // namespace slicefarm::coordinator::range_split_test
