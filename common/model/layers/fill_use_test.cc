#include "common/model/layers/fill_use.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::fill_use_test {
namespace {

using testing::ElementsAre;

FillUse Some(int32_t settings, Feature feature, std::optional<FillPattern> pattern) {
  return {settings, feature, pattern, 1, 2, 3, 4, 5, 6, 7};
}

TEST(FillUse, CopiesCountButForTheLongestPath) {
  const FillUse one = Some(1, Feature::kSolidInfill, FillPattern::kMonotonic);
  std::vector<FillUse> uses;
  AddUse(one, 3, uses);
  EXPECT_THAT(uses, ElementsAre(FillUse{1, Feature::kSolidInfill, FillPattern::kMonotonic, 3, 6, 9,
                                        12, 15, 18, 7}));
  FillUse longer = one;
  longer.longest_mm = 8;
  AddUse(longer, 1, uses);
  ASSERT_EQ(uses.size(), 1u);
  EXPECT_EQ(uses[0].paths, 20);
  EXPECT_EQ(uses[0].longest_mm, 8);
}

TEST(FillUse, WhatIsNotPrintedHasNoLongestPath) {
  FillUse use;
  use.Add(Some(0, Feature::kInternalInfill, FillPattern::kGrid), 0);
  EXPECT_EQ(use, FillUse{});
}

// Entries have the same order for any order of insertion.
TEST(FillUse, KindsStayApartAndInOrder) {
  const std::vector<FillUse> kinds = {Some(0, Feature::kInternalInfill, std::nullopt),
                                      Some(0, Feature::kInternalInfill, FillPattern::kGrid),
                                      Some(0, Feature::kInternalInfill, FillPattern::kGyroid),
                                      Some(0, Feature::kSolidInfill, FillPattern::kGrid),
                                      Some(1, Feature::kInternalInfill, FillPattern::kGrid)};
  std::vector<FillUse> forth, back;
  for (const FillUse& use : kinds) AddUse(use, 1, forth);
  for (auto use = kinds.rbegin(); use != kinds.rend(); ++use) AddUse(*use, 1, back);
  EXPECT_EQ(forth, kinds);
  EXPECT_EQ(back, kinds);
}

}  // namespace
}  // namespace slicefarm::fill_use_test
