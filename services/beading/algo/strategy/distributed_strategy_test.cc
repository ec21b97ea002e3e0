#include "services/beading/algo/strategy/distributed_strategy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/shared/shared.h"
#include "services/beading/algo/strategy/strategy_checks_test.h"

namespace slicefarm::beading::distributed_strategy_test {
namespace {

using testing::Each;
using testing::ElementsAre;

DistributedStrategy Shared(int distribution_count, Coord max_width_um = 2'000) {
  return DistributedStrategy(
      {.max_width_nm = max_width_um * kUm, .distribution_count = distribution_count});
}

TEST(Distributed, MiddleTakesItAll) {
  ExpectBeadings(Shared(1),
                 {{"None", 500, 0, {}, {}},
                  {"LoneBead", 530, 1, {530}, {265}},
                  {"TwoShare", 900, 2, {450, 450}, {225, 675}},
                  {"Optimal", 1200, 3, {400, 400, 400}, {200, 600, 1000}},
                  {"ThreeTooMuch", 2400, 3, {400, 1600, 400}, {200, 1200, 2200}},
                  {"ThreeTooLittle", 1150, 3, {400, 350, 400}, {200, 575, 950}},
                  {"BothMiddleOnesOfFour", 1700, 4, {400, 450, 450, 400}, {200, 625, 1075, 1500}},
                  {"Five", 2500, 5, {400, 400, 900, 400, 400}, {200, 600, 1250, 1900, 2300}}});
}

TEST(Distributed, TwoOnEitherSideShare) {
  ExpectBeadings(
      Shared(2),
      {{"TooMuch", 2400, 3, {760, 880, 760}, {380, 1200, 2020}},
       {"MuchTooMuch", 2500, 3, {790, 920, 790}, {395, 1250, 2105}},
       {"TooLittle", 1100, 3, {370, 360, 370}, {185, 550, 915}},
       {"Four", 1700, 4, {415, 434, 434, 415}, {207, 632, 1067, 1492}},
       {"FiveButForTheOuter", 2300, 5, {400, 490, 520, 490, 400}, {200, 645, 1150, 1655, 2100}}});
}

TEST(Distributed, ThreeOnEitherSideShare) {
  ExpectBeadings(Shared(3), {{"Three", 2400, 3, {784, 832, 784}, {392, 1200, 2008}}});
}

TEST(Distributed, NoWidthBeyondItsBounds) {
  ExpectBeadings(Shared(1, 800), {{"NoPlace", 0, 3, {0, 0, 0}, {0, 0, 0}},
                                  {"AllBelowLeast", 510, 3, {170, 170, 170}, {85, 255, 425}},
                                  {"AllLeast", 1020, 3, {340, 340, 340}, {170, 510, 850}},
                                  {"OthersGiveWay", 1080, 3, {370, 340, 370}, {185, 540, 895}},
                                  {"MiddleLeast", 1140, 3, {400, 340, 400}, {200, 570, 940}},
                                  {"MiddleGreatest", 1600, 3, {400, 800, 400}, {200, 800, 1400}},
                                  {"OthersFollow", 2000, 3, {600, 800, 600}, {300, 1000, 1700}},
                                  {"AllGreatest", 2400, 3, {800, 800, 800}, {400, 1200, 2000}},
                                  {"RestInTheMiddle", 3000, 2, {800, 800}, {400, 2600}}});
  EXPECT_EQ(Shared(1, 800).Compute(3'000 * kUm, 2).left_over_nm, 1'400 * kUm);
}

TEST(Distributed, OddThicknessOfTwoBeadsLeavesOneNm) {
  const Beading beading = Shared(1).Compute(801'001, 2);
  EXPECT_THAT(beading.widths_nm, Each(400'500));
  EXPECT_EQ(beading.left_over_nm, 1);
}

TEST(Distributed, Counts) {
  const DistributedStrategy strategy({.split_threshold = 0.7, .add_threshold = 0.85});
  EXPECT_THAT(TransitionsUm(strategy, 5), ElementsAre(340, 680, 1140, 1480, 1940));
  EXPECT_THAT(OptimalThicknessesUm(strategy, 4), ElementsAre(0, 400, 800, 1200));
  const DistributedStrategy halves({.split_threshold = 0.5, .add_threshold = 0.5});
  EXPECT_THAT(TransitionsUm(halves, 3), ElementsAre(200, 600, 1000));
  EXPECT_EQ(halves.OptimalCount(199 * kUm), 0);
  EXPECT_EQ(halves.OptimalCount(200 * kUm), 1);
  EXPECT_EQ(halves.OptimalCount(2'500 * kUm), 6);
}

TEST(Distributed, Transitions) {
  const DistributedStrategy strategy(
      {.split_threshold = 0.7, .add_threshold = 0.85, .transition_length_nm = 300 * kUm});
  EXPECT_EQ(strategy.TransitionLength(0), 10 * kUm);  // the first bead simply ends
  EXPECT_EQ(strategy.TransitionLength(1), 300 * kUm);
  EXPECT_EQ(strategy.TransitionLength(8), 300 * kUm);
  // The later one more bead is added, the closer the transition is to the side of the lower count.
  EXPECT_NEAR(strategy.TransitionAnchor(0), 0.15, 1e-6);
  EXPECT_NEAR(strategy.TransitionAnchor(1), 0.3, 1e-6);
  EXPECT_NEAR(strategy.TransitionAnchor(2), 0.15, 1e-6);
  EXPECT_TRUE(strategy.Kinks().empty());
}

class DistributionCounts : public testing::TestWithParam<int> {};

TEST_P(DistributionCounts, KeepWhatStrategiesPromise) {
  for (const Coord max_width_um : {450, 800, 10'000}) {
    SCOPED_TRACE(max_width_um);
    const DistributedStrategy strategy = Shared(GetParam(), max_width_um);
    ExpectSums(strategy);
    ExpectSymmetric(strategy);
    ExpectSideBySide(strategy);
    ExpectContinuous(strategy);
    ExpectCountsFollowTransitions(strategy);
  }
}

INSTANTIATE_TEST_SUITE_P(Distributed, DistributionCounts, testing::Values(1, 2, 3, 20));

}  // namespace
}  // namespace slicefarm::beading::distributed_strategy_test
