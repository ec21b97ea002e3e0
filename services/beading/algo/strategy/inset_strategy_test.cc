#include "services/beading/algo/strategy/inset_strategy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "services/beading/algo/strategy/distributed_strategy.h"
#include "services/beading/algo/strategy/strategy_checks_test.h"
#include "services/beading/algo/strategy/widening_strategy.h"

namespace slicefarm::beading::inset_strategy_test {
namespace {

template <typename Strategy>
Strategy Inset(Coord inset_um) {
  return Strategy(inset_um * kUm, std::make_unique<DistributedStrategy>(DistributedOptions{}));
}

TEST(OuterWallInset, MovesBothOuterBeads) {
  ExpectBeadings(Inset<OuterWallInsetStrategy>(50),
                 {{"Five", 2000, 5, {400, 400, 400, 400, 400}, {250, 600, 1000, 1400, 1750}},
                  {"Four", 1600, 4, {400, 400, 400, 400}, {250, 600, 1000, 1350}},
                  {"Two", 800, 2, {400, 400}, {250, 550}},
                  {"NotALoneOne", 400, 1, {400}, {200}},
                  {"None", 100, 0, {}, {}}});
}

TEST(OuterWallInset, NotBeyondTheMiddle) {
  ExpectBeadings(Inset<OuterWallInsetStrategy>(5'000), {{"Two", 1000, 2, {500, 500}, {500, 500}}});
}

TEST(InnerWallInset, MovesInnerBeads) {
  ExpectBeadings(Inset<InnerWallInsetStrategy>(50),
                 {{"Five", 2000, 5, {400, 400, 400, 400, 400}, {200, 650, 1000, 1350, 1800}},
                  {"Four", 1600, 4, {400, 400, 400, 400}, {200, 650, 950, 1400}},
                  {"NotTheMiddleOne", 1200, 3, {400, 400, 400}, {200, 600, 1000}},
                  {"NotTheOuterTwo", 800, 2, {400, 400}, {200, 600}},
                  {"NotALoneOne", 400, 1, {400}, {200}}});
}

TEST(InnerWallInset, NotBeyondTheMiddle) {
  ExpectBeadings(Inset<InnerWallInsetStrategy>(5'000),
                 {{"Four", 1600, 4, {400, 400, 400, 400}, {200, 800, 800, 1400}}});
}

template <typename Strategy>
class Insets : public testing::Test {};
using BothInsets = testing::Types<OuterWallInsetStrategy, InnerWallInsetStrategy>;
TYPED_TEST_SUITE(Insets, BothInsets);

TYPED_TEST(Insets, ChangeNothingButLocations) {
  const WideningStrategy plain({}, std::make_unique<DistributedStrategy>(DistributedOptions{}));
  const TypeParam inset(50 * kUm, std::make_unique<WideningStrategy>(
                                      WideningOptions{},
                                      std::make_unique<DistributedStrategy>(DistributedOptions{})));
  for (int n = 0; n <= kMostBeads; ++n) {
    EXPECT_EQ(inset.OptimalThickness(n), plain.OptimalThickness(n));
    EXPECT_EQ(inset.TransitionThickness(n), plain.TransitionThickness(n));
    EXPECT_EQ(inset.TransitionLength(n), plain.TransitionLength(n));
    EXPECT_EQ(inset.TransitionAnchor(n), plain.TransitionAnchor(n));
    for (Coord d = 0; d < kThickest; d += kStep) {
      Beading beading = inset.Compute(d, n);
      beading.locations_nm = plain.Compute(d, n).locations_nm;
      ASSERT_EQ(beading, plain.Compute(d, n)) << d << " in " << n;
      ASSERT_EQ(inset.OptimalCount(d), plain.OptimalCount(d)) << d;
    }
  }
  EXPECT_EQ(inset.Kinks(), plain.Kinks());
}

TYPED_TEST(Insets, StaySymmetric) {
  ExpectSymmetric(Inset<TypeParam>(50));
  ExpectSymmetric(Inset<TypeParam>(5'000));
}

}  // namespace
}  // namespace slicefarm::beading::inset_strategy_test
