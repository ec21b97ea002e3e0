#include "services/beading/algo/strategy/limited_strategy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/beading/algo/strategy/distributed_strategy.h"
#include "services/beading/algo/strategy/strategy_checks_test.h"
#include "services/beading/algo/strategy/widening_strategy.h"

namespace slicefarm::beading::limited_strategy_test {
namespace {

using testing::ElementsAre;

LimitedStrategy AtMost(int max_count) {
  return {max_count, std::make_unique<DistributedStrategy>(DistributedOptions{})};
}

TEST(Limited, AMarkerInTheMiddleOfTheMostBeads) {
  ExpectBeadings(
      AtMost(6),
      {{"Six",
        2400,
        6,
        {400, 400, 400, 0, 400, 400, 400},
        {200, 600, 1000, 1200, 1400, 1800, 2200}},
       {"FewerHaveNone", 2000, 5, {400, 400, 400, 400, 400}, {200, 600, 1000, 1400, 1800}},
       {"OneHasNone", 400, 1, {400}, {200}}});
  ExpectBeadings(AtMost(2), {{"Two", 1600, 2, {800, 0, 800}, {400, 800, 1200}}});
}

TEST(Limited, AMarkerAtEitherSideOfTheInfill) {
  ExpectBeadings(AtMost(6), {{"Thick",
                              5001,
                              7,
                              {400, 400, 400, 0, 0, 400, 400, 400},
                              {200, 600, 1000, 1200, 3801, 4001, 4401, 4801}}});
  EXPECT_EQ(AtMost(6).Compute(5'001 * kUm, 7).left_over_nm, 2'601 * kUm);
  ExpectBeadings(AtMost(2), {{"Thick", 2000, 3, {400, 0, 0, 400}, {200, 400, 1600, 1800}},
                             {"NoInfill", 700, 3, {350, 0, 0, 350}, {175, 350, 350, 525}}});
}

TEST(Limited, Counts) {
  const auto strategy = AtMost(6);
  EXPECT_EQ(strategy.OptimalCount(2'789 * kUm), 6);
  EXPECT_EQ(strategy.OptimalCount(2'790 * kUm), 7);  // slightly less than the 2800 of seven beads
  EXPECT_EQ(strategy.OptimalCount(100'000 * kUm), 7);
  EXPECT_EQ(strategy.OptimalCount(400 * kUm), 1);
  EXPECT_EQ(strategy.TransitionThickness(7), kUnreachableNm);
  EXPECT_THAT(TransitionsUm(AtMost(2), 3), ElementsAre(340, 680, 1190));
  EXPECT_THAT(OptimalThicknessesUm(AtMost(2), 6), ElementsAre(0, 400, 800, 1200, 1200, 1200));
}

TEST(Limited, NoBeadAtAll) {
  const auto strategy = AtMost(0);
  EXPECT_THAT(TransitionsUm(strategy, 1), ElementsAre(390));
  EXPECT_EQ(strategy.OptimalCount(2'000 * kUm), 1);
  ExpectBeadings(strategy, {{"Thin", 300, 0, {}, {}}, {"Thick", 2000, 1, {}, {}}});
  ExpectSums(strategy);
}

TEST(Limited, TransitionsAreTheParents) {
  EXPECT_EQ(AtMost(2).TransitionLength(0), 10 * kUm);
  EXPECT_EQ(AtMost(2).TransitionLength(2), 400 * kUm);
  EXPECT_NEAR(AtMost(2).TransitionAnchor(0), 0.15, 1e-6);
  EXPECT_NEAR(AtMost(2).TransitionAnchor(1), 0.3, 1e-6);
}

TEST(Limited, KinksAreInOrder) {
  const LimitedStrategy strategy(2,
                                 std::make_unique<WideningStrategy>(
                                     WideningOptions{.min_width_nm = 900 * kUm},
                                     std::make_unique<DistributedStrategy>(DistributedOptions{})));
  EXPECT_THAT(InUm(strategy.Kinks()), ElementsAre(800, 900));
}

TEST(Limited, NotBeforeTheParentHasAllBeads) {
  const LimitedStrategy strategy(2,
                                 std::make_unique<WideningStrategy>(
                                     WideningOptions{.min_feature_nm = 2'000 * kUm},
                                     std::make_unique<DistributedStrategy>(DistributedOptions{})));
  EXPECT_THAT(TransitionsUm(strategy, 3), ElementsAre(2000, 2000, 2000));
  ExpectCountsFollowTransitions(strategy);
}

TEST(Limited, KeepsWhatStrategiesPromise) {
  for (const int max_count : {2, 4, 6}) {
    SCOPED_TRACE(max_count);
    ExpectSums(AtMost(max_count));
    ExpectSymmetric(AtMost(max_count));
    ExpectSideBySide(AtMost(max_count));
    ExpectContinuous(AtMost(max_count));
    ExpectCountsFollowTransitions(AtMost(max_count));
  }
}

TEST(Limited, TheOutermostStandApartWhereThereIsInfill) {
  const LimitedStrategy apart{4, std::make_unique<DistributedStrategy>(DistributedOptions{}),
                              50 * kUm};
  ExpectBeadings(
      apart,
      {{"Thick", 5000, 5, {400, 400, 0, 0, 400, 400}, {200, 650, 850, 4150, 4350, 4800}},
       {"Full", 1600, 4, {400, 400, 0, 400, 400}, {200, 600, 800, 1000, 1400}},
       {"LittleIsLeft", 1640, 5, {400, 400, 0, 0, 400, 400}, {200, 620, 820, 820, 1020, 1440}}});
  ExpectSums(apart);
}

}  // namespace
}  // namespace slicefarm::beading::limited_strategy_test
