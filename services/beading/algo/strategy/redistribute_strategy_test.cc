#include "services/beading/algo/strategy/redistribute_strategy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/beading/algo/strategy/distributed_strategy.h"
#include "services/beading/algo/strategy/strategy_checks_test.h"
#include "services/beading/algo/strategy/widening_strategy.h"

namespace slicefarm::beading::redistribute_strategy_test {
namespace {

using testing::ElementsAre;

RedistributeStrategy Over(Coord inner_width_um, const RedistributeOptions& options) {
  return RedistributeStrategy(
      options, std::make_unique<DistributedStrategy>(DistributedOptions{
                   .optimal_width_nm = inner_width_um * kUm, .max_width_nm = 2'000 * kUm}));
}

TEST(Redistribute, OuterBeadsKeepTheirWidth) {
  ExpectBeadings(Over(400, {}),
                 {{"Three", 2400, 3, {400, 1600, 400}, {200, 1200, 2200}},
                  {"Four", 1600, 4, {400, 400, 400, 400}, {200, 600, 1000, 1400}},
                  {"Five", 2500, 5, {400, 400, 900, 400, 400}, {200, 600, 1250, 1900, 2300}},
                  {"FiveOdd", 2203, 5, {400, 400, 603, 400, 400}, {200, 600, 1101, 1603, 2003}}});
  ExpectBeadings(Over(450, {.outer_width_nm = 350 * kUm}),
                 {{"Unequal", 2500, 5, {350, 450, 900, 450, 350}, {175, 575, 1250, 1925, 2325}}});
}

TEST(Redistribute, OneOrTwoShareEvenly) {
  ExpectBeadings(Over(400, {}), {{"None", 150, 0, {}, {}},
                                 {"One", 500, 1, {500}, {250}},
                                 {"Two", 1000, 2, {500, 500}, {250, 750}},
                                 {"TwoGreatest", 1600, 2, {800, 800}, {400, 1200}},
                                 {"OneTooWide", 1000, 1, {800}, {500}},
                                 {"TwoTooWide", 2000, 2, {800, 800}, {400, 1600}}});
}

TEST(Redistribute, AllShrinkWhereInnerBeadsDoNotFit) {
  const auto strategy = Over(400, {.min_width_nm = 340 * kUm});
  ExpectBeadings(strategy, {{"JustFit", 1140, 3, {400, 340, 400}, {200, 570, 940}},
                            {"Half", 570, 3, {200, 170, 200}, {100, 285, 470}},
                            {"HalfOfFour", 740, 4, {200, 170, 170, 200}, {100, 285, 455, 640}},
                            {"NoPlace", 0, 3, {0, 0, 0}, {0, 0, 0}}});
}

TEST(Redistribute, LockedOuterWidth) {
  const auto strategy = Over(400, {.lock_outer_width = true});
  ExpectBeadings(strategy, {{"BeforeTheTransition", 1138, 2, {569, 569}, {284, 853}},
                            {"InTheTransition", 1140, 2, {400, 400}, {200, 940}},
                            {"ThreeAreNot", 1300, 3, {400, 500, 400}, {200, 650, 1100}}});
  EXPECT_EQ(strategy.Compute(1'140 * kUm, 2).left_over_nm, 340 * kUm);
}

TEST(Redistribute, Counts) {
  const auto strategy = Over(400, {});
  EXPECT_THAT(TransitionsUm(strategy, 6), ElementsAre(200, 680, 1140, 1480, 1940, 2280));
  EXPECT_EQ(strategy.OptimalCount(199 * kUm), 0);
  EXPECT_EQ(strategy.OptimalCount(200 * kUm), 1);
  EXPECT_EQ(strategy.OptimalCount(1'480 * kUm), 4);
}

TEST(Redistribute, CountsOfUnequalWidths) {
  const auto strategy = Over(450, {.outer_width_nm = 350 * kUm, .min_outer_share = 0.4});
  EXPECT_THAT(OptimalThicknessesUm(strategy, 6), ElementsAre(0, 350, 700, 1150, 1600, 2050));
  EXPECT_THAT(TransitionsUm(strategy, 4), ElementsAre(140, 595, 1082, 1465));
}

TEST(Redistribute, TransitionsOfOuterBeadsAreItsOwn) {
  const auto strategy = Over(450, {.outer_width_nm = 350 * kUm, .split_threshold = 0.6});
  EXPECT_NEAR(strategy.TransitionAnchor(0), 0.5, 1e-6);
  EXPECT_NEAR(strategy.TransitionAnchor(1), 0.4, 1e-6);
  EXPECT_NEAR(strategy.TransitionAnchor(2), 0.15, 1e-6);  // parent's value from 0 to 1
  EXPECT_NEAR(strategy.TransitionAnchor(3), 0.3, 1e-6);   // parent's value from 1 to 2
  EXPECT_EQ(strategy.TransitionLength(0), 10 * kUm);
  for (const int n : {1, 2, 3, 4}) EXPECT_EQ(strategy.TransitionLength(n), 400 * kUm) << n;
}

TEST(Redistribute, KinksAreTheParentsBetweenOuterBeads) {
  const RedistributeStrategy strategy(
      {.outer_width_nm = 350 * kUm},
      std::make_unique<WideningStrategy>(
          WideningOptions{}, std::make_unique<DistributedStrategy>(DistributedOptions{})));
  EXPECT_THAT(strategy.Kinks(), ElementsAre(1'040 * kUm));
}

TEST(Redistribute, KeepsWhatStrategiesPromise) {
  for (const Coord outer_um : {300, 400, 700}) {
    SCOPED_TRACE(outer_um);
    const auto strategy = Over(400, {.outer_width_nm = outer_um * kUm});
    ExpectSums(strategy);
    ExpectSymmetric(strategy);
    ExpectSideBySide(strategy);
    ExpectContinuous(strategy);
    ExpectCountsFollowTransitions(strategy);
  }
}

}  // namespace
}  // namespace slicefarm::beading::redistribute_strategy_test
