#include "services/beading/algo/strategy/widening_strategy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/beading/algo/strategy/distributed_strategy.h"
#include "services/beading/algo/strategy/strategy_checks_test.h"

namespace slicefarm::beading::widening_strategy_test {
namespace {

using testing::ElementsAre;

WideningStrategy Widened(const WideningOptions& options) {
  return {options, std::make_unique<DistributedStrategy>(DistributedOptions{})};
}

TEST(Widening, ALoneBeadHasTheLeastWidth) {
  ExpectBeadings(Widened({}), {{"TooThin", 99, 1, {}, {}},
                               {"Thinnest", 100, 1, {340}, {50}},
                               {"Thin", 300, 1, {340}, {150}},
                               {"Least", 340, 1, {340}, {170}},
                               {"Enough", 500, 1, {500}, {250}},
                               {"OnlyALoneOne", 300, 2, {150, 150}, {75, 225}}});
}

TEST(Widening, ALeastWidthBelowTheThicknessChangesNothing) {
  ExpectBeadings(Widened({.min_width_nm = 100 * kUm}), {{"Thin", 300, 1, {300}, {150}}});
}

TEST(Widening, WhatPassesTheOutlineIsANegativeLeftOver) {
  EXPECT_EQ(Widened({}).Compute(300 * kUm, 1).left_over_nm, -40 * kUm);
  EXPECT_EQ(Widened({}).Compute(90 * kUm, 1).left_over_nm, 90 * kUm);
}

TEST(Widening, Counts) {
  const auto strategy = Widened({});
  EXPECT_EQ(strategy.OptimalCount(99 * kUm), 0);
  EXPECT_EQ(strategy.OptimalCount(100 * kUm), 1);
  EXPECT_EQ(strategy.OptimalCount(679 * kUm), 1);
  EXPECT_EQ(strategy.OptimalCount(680 * kUm), 2);
  EXPECT_THAT(TransitionsUm(strategy, 3), ElementsAre(100, 680, 1140));
  EXPECT_THAT(OptimalThicknessesUm(strategy, 3), ElementsAre(0, 400, 800));
}

TEST(Widening, FeaturesBeyondTheFirstTransition) {
  const auto strategy = Widened({.min_feature_nm = 900 * kUm});
  EXPECT_EQ(strategy.OptimalCount(899 * kUm), 0);
  EXPECT_EQ(strategy.OptimalCount(900 * kUm), 2);
  EXPECT_THAT(TransitionsUm(strategy, 3), ElementsAre(900, 900, 1140));
  ExpectCountsFollowTransitions(strategy);
}

TEST(Widening, KinkAtTheLeastWidth) {
  EXPECT_THAT(Widened({}).Kinks(), ElementsAre(340 * kUm));
  const WideningStrategy twice(
      {}, std::make_unique<WideningStrategy>(Widened({.min_width_nm = 500 * kUm})));
  EXPECT_THAT(twice.Kinks(), ElementsAre(340 * kUm, 500 * kUm));
}

TEST(Widening, KeepsWhatStrategiesPromise) {
  const auto strategy = Widened({});
  ExpectSums(strategy);
  ExpectSymmetric(strategy);
  ExpectSideBySide(strategy);
  ExpectContinuous(strategy, 100 * kUm);
  ExpectCountsFollowTransitions(strategy);
}

}  // namespace
}  // namespace slicefarm::beading::widening_strategy_test
