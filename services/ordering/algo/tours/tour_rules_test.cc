#include "services/ordering/algo/tours/tour_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::ordering::tour_rules_test {
namespace {

using ::testing::ElementsAre;

TEST(FixedEdges, KnowsBothMates) {
  const std::vector<NodePair> edges = {{0, 1}, {2, 1}};
  const FixedEdges fixed(4, edges);
  EXPECT_TRUE(fixed.Has(1, 0));
  EXPECT_TRUE(fixed.Has(1, 2));
  EXPECT_FALSE(fixed.Has(0, 2));
  EXPECT_EQ(fixed.Of(3)[0], FixedEdges::kNone);
}

struct FixCase {
  const char* name;
  Tour tour;
  std::vector<NodePair> edges;
  Tour kept;
};

class WithFixedEdgesTest : public testing::TestWithParam<FixCase> {};

TEST_P(WithFixedEdgesTest, MovesNodes) {
  const FixCase& c = GetParam();
  const auto size = static_cast<int32_t>(c.tour.size());
  const Tour kept = WithFixedEdges(c.tour, FixedEdges(size, c.edges));
  EXPECT_EQ(kept, c.kept);
  EXPECT_TRUE(Keeps(kept, size, {.fixed = c.edges, .before = {}}));
}

INSTANTIATE_TEST_SUITE_P(
    TourRules, WithFixedEdgesTest,
    testing::Values(
        FixCase{"None", {2, 0, 1}, {}, {2, 0, 1}},
        FixCase{"Pair", {0, 1, 2, 3}, {{3, 0}}, {0, 3, 1, 2}},
        FixCase{"ChainFromItsEnd", {0, 1, 2, 3}, {{0, 2}, {2, 1}}, {0, 2, 1, 3}},
        FixCase{"ChainFromItsMiddle", {2, 0, 1, 3, 4}, {{0, 2}, {2, 4}, {4, 1}}, {0, 2, 4, 1, 3}},
        FixCase{"Ring", {0, 1, 2, 3}, {{0, 2}, {2, 1}, {1, 3}, {3, 0}}, {0, 2, 1, 3}}),
    [](const auto& info) { return info.param.name; });

struct KeepsCase {
  const char* name;
  Tour tour;
  TourRules rules;
  bool kept;
};

class KeepsTest : public testing::TestWithParam<KeepsCase> {};

TEST_P(KeepsTest, Says) { EXPECT_EQ(Keeps(GetParam().tour, 4, GetParam().rules), GetParam().kept); }

INSTANTIATE_TEST_SUITE_P(
    TourRules, KeepsTest,
    testing::Values(KeepsCase{"Plain", {3, 1, 0, 2}, {}, true},
                    KeepsCase{"TooShort", {3, 1, 0}, {}, false},
                    KeepsCase{"Twice", {3, 1, 0, 3}, {}, false},
                    KeepsCase{"Unknown", {4, 1, 0, 3}, {}, false},
                    KeepsCase{"Negative", {-1, 1, 0, 3}, {}, false},
                    KeepsCase{"FixedAllAround", {3, 1, 0, 2}, {{{2, 3}}, {}}, true},
                    KeepsCase{"FixedApart", {3, 1, 0, 2}, {{{3, 0}}, {}}, false},
                    KeepsCase{"Before", {0, 1, 2, 3}, {{{3, 0}}, {{1, 2}}, 0, 3}, true},
                    KeepsCase{"BeforeBackward", {3, 2, 1, 0}, {{{3, 0}}, {{1, 2}}, 0, 3}, true},
                    KeepsCase{"BeforeTurned", {1, 0, 3, 2}, {{{3, 0}}, {{1, 2}}, 0, 3}, true},
                    KeepsCase{"Behind", {0, 2, 1, 3}, {{{3, 0}}, {{1, 2}}, 0, 3}, false},
                    KeepsCase{"BehindBackward", {3, 1, 2, 0}, {{{3, 0}}, {{1, 2}}, 0, 3}, false}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::ordering::tour_rules_test
