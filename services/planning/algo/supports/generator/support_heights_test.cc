#include "services/planning/algo/supports/generator/support_heights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::support_heights_test {
namespace {

using testing::ElementsAre;

/// Returns overhangs in some layers of a part.
std::vector<Overhang> In(size_t layers, const std::vector<size_t>& which) {
  std::vector<Overhang> overhangs(layers);
  for (const size_t i : which) overhangs[i].contact = overhangs[i].steep = BoxOf(0, 0, 1, 1);
  return overhangs;
}

std::vector<double> Tops(const SupportHeights& heights) {
  std::vector<double> tops;
  Coord below = 0;
  for (const SupportHeight& layer : heights.layers) {
    EXPECT_EQ(layer.bottom_nm, below);
    below = layer.top_nm;
    tops.push_back(ToMm(static_cast<double>(layer.top_nm)));
  }
  return tops;
}

const TestStack kPart(20, [](double) { return BoxOf(0, 0, 1, 1); });

TEST(HeightsFor, NothingHangsNothingIsBuilt) {
  EXPECT_EQ(HeightsFor(kPart.Problem(), In(20, {}), {}).layers.size(), 0u);
}

TEST(HeightsFor, TopsAreTheGapBelowWhatHangs) {
  SupportOptions options;
  const SupportHeights heights = HeightsFor(kPart.Problem(), In(20, {5, 6}), options);
  EXPECT_THAT(Tops(heights), ElementsAre(0.2, 0.4, 0.6, 0.8, 1.0));
  EXPECT_EQ(heights.under[5], 3);
  EXPECT_EQ(heights.under[6], 4);
  EXPECT_EQ(heights.under[7], -1);
}

TEST(HeightsFor, ContactsHaveHeightsOfTheirOwn) {
  SupportOptions options;
  options.top_gap_nm = 150'000;
  EXPECT_THAT(Tops(HeightsFor(kPart.Problem(), In(20, {4, 5}), options)),
              ElementsAre(0.2, 0.35, 0.5, 0.65, 0.85));
  options.layer_height_nm = 300'000;
  EXPECT_THAT(Tops(HeightsFor(kPart.Problem(), In(20, {4, 5}), options)),
              ElementsAre(0.2, 0.425, 0.65, 0.85));
}

TEST(HeightsFor, TopsTooNearToEachOtherBecomeTheLowerOne) {
  SupportProblem problem = kPart.Problem();
  for (size_t i = 10; i < problem.part.size(); ++i) problem.part[i].top_nm -= 150'000;
  problem.part[10].height_nm = 50'000;
  const SupportHeights heights = HeightsFor(problem, In(20, {10, 11}), {});
  EXPECT_EQ(heights.under[10], heights.under[11]);
  EXPECT_EQ(heights.layers.back().top_nm, 1'800'000);
}

TEST(HeightsFor, NoRoomUnderTheSecondLayer) {
  const SupportHeights heights = HeightsFor(kPart.Problem(), In(20, {1, 2}), {});
  EXPECT_EQ(heights.under[1], -1);
  EXPECT_EQ(heights.under[2], 0);
  EXPECT_THAT(Tops(heights), ElementsAre(0.2));
}

// A lower layer would bring the nozzle too near to the bed and add a layer below the part's first
// layer.
TEST(HeightsFor, TheFirstLayerIsNeverLowerThanThePartsOwn) {
  SupportOptions options;
  options.top_gap_nm = 150'000;
  const struct {
    const char* name;
    std::vector<size_t> hanging;
    std::vector<double> tops;
  } cases[] = {
      {"below it", {1}, {}},              // height 0.05 mm
      {"a little above it", {2}, {0.2}},  // height 0.25 mm
      {"both, and more", {1, 2, 3}, {0.2, 0.325, 0.45}},
  };
  for (const auto& [name, hanging, tops] : cases) {
    const SupportHeights heights = HeightsFor(kPart.Problem(), In(20, hanging), options);
    EXPECT_EQ(Tops(heights), tops) << name;
    EXPECT_EQ(heights.under[1], -1) << name;
  }
}

TEST(HeightsFor, LayersThatLieNearThePartsAreAtItsHeights) {
  SupportOptions options;
  options.top_gap_nm = 195'000;
  // A top at 1.005 would add a layer of the print beside 1.0. The layers between are fifths of the
  // distance.
  const SupportHeights heights = HeightsFor(kPart.Problem(), In(20, {6}), options);
  EXPECT_THAT(Tops(heights), ElementsAre(0.2, 0.4, 0.6, 0.8, 1.0));
}

TEST(HeightsFor, SynchronizedTopsAreThePartsOwn) {
  SupportOptions options;
  options.top_gap_nm = 150'000;
  options.synchronize_layers = true;
  const SupportHeights heights = HeightsFor(kPart.Problem(), In(20, {4}), options);
  EXPECT_THAT(Tops(heights), ElementsAre(0.2, 0.4, 0.6));
  EXPECT_EQ(heights.under[4], 2);
}

struct TreeCase {
  const char* name;
  Coord gap_nm;
  std::vector<size_t> overhangs;
  std::vector<double> tops;
};

class TreeHeightsTest : public testing::TestWithParam<TreeCase> {};

TEST_P(TreeHeightsTest, EndWhereThePartsLayersDo) {
  SupportOptions options;
  options.style = SupportStyle::kTree;
  options.top_gap_nm = GetParam().gap_nm;
  const auto heights = HeightsFor(kPart.Problem(), In(20, GetParam().overhangs), options);
  EXPECT_THAT(Tops(heights), testing::ElementsAreArray(GetParam().tops));
  for (const size_t i : GetParam().overhangs) EXPECT_GE(heights.under[i], 0);
}

INSTANTIATE_TEST_SUITE_P(
    Gaps, TreeHeightsTest,
    testing::Values(TreeCase{"ALayer", 200'000, {5, 6}, {0.2, 0.4, 0.6, 0.8, 1.0}},
                    TreeCase{"LessThanALayer", 150'000, {5, 6}, {0.2, 0.4, 0.6, 0.8, 1.0}},
                    TreeCase{"HalfALayer", 100'000, {5}, {0.2, 0.4, 0.6, 0.8}},
                    // A contact that would move down by more keeps its distance and has a height of
                    // its own.
                    TreeCase{"LittleMoreThanALayer",
                             250'000,
                             {5, 9},
                             {0.2, 0.4, 0.6, 0.75, 0.875, 1.0, 1.2, 1.4, 1.55}},
                    TreeCase{"None", 0, {4}, {0.2, 0.4, 0.6, 0.8}}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::planning::support_heights_test
