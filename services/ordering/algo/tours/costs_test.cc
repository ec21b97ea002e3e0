#include "services/ordering/algo/tours/costs.h"

#include <gtest/gtest.h>

namespace slicefarm::ordering::costs_test {
namespace {

struct RoundingCase {
  const char* name;
  Metric metric;
  Vector2 to = Vector2::Zero();
  int64_t length;
};

class RoundingTest : public testing::TestWithParam<RoundingCase> {};

TEST_P(RoundingTest, FromTheOrigin) {
  const Costs costs = Costs::OfPoints({{0, 0}, GetParam().to}, GetParam().metric);
  EXPECT_EQ(costs(0, 1), GetParam().length);
  EXPECT_EQ(costs(1, 0), GetParam().length);
  EXPECT_EQ(costs(1, 1), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Costs, RoundingTest,
    testing::Values(RoundingCase{"Exact", Metric::kNearest, {3, 4}, 5},
                    RoundingCase{"Down", Metric::kNearest, {1, 1}, 1},
                    RoundingCase{"HalfUp", Metric::kNearest, {2.5, 0}, 3},
                    RoundingCase{"Up", Metric::kUp, {1, 1}, 2},
                    RoundingCase{"UpOfExact", Metric::kUp, {3, 4}, 5},
                    // sqrt(100 / 10) = 3.16 rounds to 3, which is less, so that ATT adds 1.
                    RoundingCase{"AttAddsOne", Metric::kAtt, {10, 0}, 4},
                    // sqrt(140 / 10) = 3.74 rounds to 4.
                    RoundingCase{"AttRounds", Metric::kAtt, {2, 11.661903789690601}, 4}),
    [](const auto& info) { return info.param.name; });

TEST(Costs, OfATable) {
  const Costs costs = Costs::OfTable(3, {0, 1, 2, 1, 0, 3, 2, 3, 0});
  EXPECT_EQ(costs(0, 2), 2);
  EXPECT_EQ(costs(2, 1), 3);
  EXPECT_FALSE(costs.has_points());
}

TEST(Costs, NowhereIsAtNoDistance) {
  for (Costs costs :
       {Costs::OfPoints({{0, 0}, {9, 0}}, Metric::kNearest), Costs::OfTable(2, {0, 9, 9, 0})}) {
    const int32_t nowhere = costs.AddNowhere();
    EXPECT_EQ(nowhere, 2);
    EXPECT_EQ(costs.size(), 3);
    EXPECT_TRUE(costs.IsNowhere(2));
    EXPECT_FALSE(costs.IsNowhere(1));
    EXPECT_EQ(costs(0, 2) + costs(2, 1), 0);
    EXPECT_EQ(costs(0, 1), 9);
  }
}

TEST(Costs, TourLengthGoesBackToTheFirst) {
  const Costs costs = Costs::OfPoints({{0, 0}, {3, 0}, {3, 4}}, Metric::kNearest);
  EXPECT_EQ(TourLength(costs, {0, 1, 2}), 12);
  EXPECT_EQ(TourLength(costs, {1}), 0);
}

}  // namespace
}  // namespace slicefarm::ordering::costs_test
