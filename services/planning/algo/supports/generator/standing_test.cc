#include "services/planning/algo/supports/generator/standing.h"

#include <gtest/gtest.h>

#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::standing_test {
namespace {

std::vector<SupportLayer> Layers(const std::vector<MultiPolygon>& regions) {
  std::vector<SupportLayer> layers;
  for (size_t i = 0; i < regions.size(); ++i)
    layers.push_back(
        {static_cast<Coord>(i + 1) * 200'000, 200'000, i == 0, {{SupportRole::kBase, regions[i]}}});
  return layers;
}

std::vector<SupportLayer> Kept(const SupportProblem& problem, std::vector<SupportLayer> layers,
                               const SupportOptions& options = {}) {
  KeepStanding(problem, options, 2, CancelToken(), layers);
  return layers;
}

TEST(KeepStanding, LeavesWhatStandsAsItIs) {
  const auto layers = Layers({BoxOf(0, 0, 5, 5), BoxOf(0, 0, 5, 5), BoxOf(0.5, 0, 5.5, 5)});
  EXPECT_EQ(Kept({}, layers), layers);
}

TEST(KeepStanding, TakesAwayWhatHangsInTheAirAndAllThatStandsOnIt) {
  const MultiPolygon stands = BoxOf(0, 0, 5, 5), hangs = BoxOf(7, 0, 8, 5);
  const auto kept =
      Kept({}, Layers({stands, Union(stands, hangs), Union(stands, hangs), Union(stands, hangs)}));
  ASSERT_EQ(kept.size(), 4u);
  for (const SupportLayer& layer : kept) EXPECT_NEAR(AreaMm2(layer.regions[0].outlines), 25, 0.01);
}

TEST(KeepStanding, CutsWhatReachesTooFar) {
  const auto kept = Kept({}, Layers({BoxOf(0, 0, 5, 5), BoxOf(0, 0, 8, 5)}));
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_NEAR(AreaMm2(kept[1].regions[0].outlines), 5.95 * 5, 0.02);
}

TEST(KeepStanding, ThePartCarriesIfItMay) {
  const TestStack part(2, [](double) { return BoxOf(0, 0, 5, 5); });
  auto layers = Layers({{}, {}, {}, BoxOf(1, 1, 3, 3)});
  layers.erase(layers.begin(), layers.begin() + 3);
  EXPECT_EQ(Kept(part.Problem(), layers), layers);
  SupportOptions on_bed;
  on_bed.bed_only = true;
  EXPECT_TRUE(Kept(part.Problem(), layers, on_bed).empty());
}

TEST(KeepStanding, RegionsThatTouchCarryEachOther) {
  auto layers = Layers({BoxOf(0, 0, 1, 5), BoxOf(0, 0, 1, 5)});
  layers[1].regions.push_back({SupportRole::kTopInterface, BoxOf(1, 0, 1.5, 5)});
  EXPECT_EQ(Kept({}, layers), layers);
}

}  // namespace
}  // namespace slicefarm::planning::standing_test
