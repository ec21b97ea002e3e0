#include "services/beading/algo/strategy/margin_strategy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/beading/algo/strategy/distributed_strategy.h"
#include "services/beading/algo/strategy/limited_strategy.h"
#include "services/beading/algo/strategy/strategy_checks_test.h"

namespace slicefarm::beading::margin_strategy_test {
namespace {

using testing::ElementsAre;

MarginStrategy WithMargin(Coord margin_nm) {
  return {margin_nm, std::make_unique<DistributedStrategy>(DistributedOptions{})};
}

MarginStrategy LimitedWithMargin(Coord margin_nm) {
  return {margin_nm, std::make_unique<LimitedStrategy>(
                         2, std::make_unique<DistributedStrategy>(DistributedOptions{}))};
}

TEST(Margin, BeadsLieBetween) {
  ExpectBeadings(WithMargin(50 * kUm), {{"None", 500, 0, {}, {}},
                                        {"One", 500, 1, {400}, {250}},
                                        {"Two", 900, 2, {400, 400}, {250, 650}},
                                        {"Three", 1400, 3, {400, 500, 400}, {250, 700, 1150}},
                                        {"NothingButMargin", 60, 1, {0}, {30}}});
  EXPECT_EQ(WithMargin(50 * kUm).Compute(900 * kUm, 2).left_over_nm, 100 * kUm);
}

TEST(Margin, MarkersMoveAlong) {
  ExpectBeadings(LimitedWithMargin(50 * kUm),
                 {{"Thick", 2100, 3, {400, 0, 0, 400}, {250, 450, 1650, 1850}}});
}

TEST(Margin, MirrorImagesOfAnOddRestOfPlace) {
  EXPECT_THAT(WithMargin(50).Compute(61, 2).locations_nm, ElementsAre(30, 31));
}

TEST(Margin, CountsAreThoseOfThePlaceBetween) {
  const auto strategy = WithMargin(50 * kUm);
  EXPECT_THAT(TransitionsUm(strategy, 3), ElementsAre(440, 780, 1240));
  EXPECT_THAT(OptimalThicknessesUm(strategy, 4), ElementsAre(100, 500, 900, 1300));
  EXPECT_EQ(strategy.OptimalCount(0), 0);
  EXPECT_EQ(strategy.OptimalCount(439 * kUm), 0);
  EXPECT_EQ(strategy.OptimalCount(440 * kUm), 1);
  EXPECT_EQ(strategy.TransitionLength(0), 10 * kUm);
  EXPECT_EQ(strategy.TransitionLength(1), 400 * kUm);
  EXPECT_NEAR(strategy.TransitionAnchor(1), 0.3, 1e-6);
}

TEST(Margin, KinksMoveAlongAndTheUnreachableStays) {
  const auto strategy = LimitedWithMargin(50 * kUm);
  EXPECT_THAT(strategy.Kinks(), ElementsAre(900 * kUm));
  EXPECT_EQ(strategy.TransitionThickness(3), kUnreachableNm);
}

TEST(Margin, KeepsWhatStrategiesPromise) {
  const auto strategy = WithMargin(50'001);
  ExpectSums(strategy);
  ExpectSymmetric(strategy);
  ExpectSideBySide(strategy);
  ExpectContinuous(strategy);
  ExpectCountsFollowTransitions(strategy);
}

}  // namespace
}  // namespace slicefarm::beading::margin_strategy_test
