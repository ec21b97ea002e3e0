#include "common/model/layers/fill_stats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::fill_stats_test {
namespace {

using testing::ElementsAre;

FillStats Some(int32_t settings, Feature feature, std::optional<FillPattern> pattern) {
  return {settings, feature, pattern, 1, 2, 3, 4, 5, 6, 7};
}

TEST(FillStats, CopiesCountButForTheLongestPath) {
  const FillStats one = Some(1, Feature::kSolidInfill, FillPattern::kMonotonic);
  std::vector<FillStats> uses;
  AddUse(one, 3, uses);
  EXPECT_THAT(uses, ElementsAre(FillStats{1, Feature::kSolidInfill, FillPattern::kMonotonic, 3, 6,
                                          9, 12, 15, 18, 7}));
  FillStats longer = one;
  longer.longest_mm = 8;
  AddUse(longer, 1, uses);
  ASSERT_EQ(uses.size(), 1u);
  EXPECT_EQ(uses[0].paths, 20);
  EXPECT_EQ(uses[0].longest_mm, 8);
}

TEST(FillStats, WhatIsNotPrintedHasNoLongestPath) {
  FillStats use;
  use.Add(Some(0, Feature::kInternalInfill, FillPattern::kGrid), 0);
  EXPECT_EQ(use, FillStats{});
}

// Entries have the same order for any order of insertion.
TEST(FillStats, KindsStayApartAndInOrder) {
  const std::vector<FillStats> kinds = {Some(0, Feature::kInternalInfill, std::nullopt),
                                        Some(0, Feature::kInternalInfill, FillPattern::kGrid),
                                        Some(0, Feature::kInternalInfill, FillPattern::kGyroid),
                                        Some(0, Feature::kSolidInfill, FillPattern::kGrid),
                                        Some(1, Feature::kInternalInfill, FillPattern::kGrid)};
  std::vector<FillStats> forth, back;
  for (const FillStats& use : kinds) AddUse(use, 1, forth);
  for (auto use = kinds.rbegin(); use != kinds.rend(); ++use) AddUse(*use, 1, back);
  EXPECT_EQ(forth, kinds);
  EXPECT_EQ(back, kinds);
}

}  // namespace
}  // namespace slicefarm::fill_stats_test
