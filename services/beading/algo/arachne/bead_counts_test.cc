#include "services/beading/algo/arachne/bead_counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>

#include "common/geometry/text_format_test.h"
#include "services/beading/algo/skeleton/centrality.h"
#include "services/beading/algo/strategy/strategy_factory.h"

namespace slicefarm::beading::bead_counts_test {
namespace {

std::unique_ptr<const BeadingStrategy> Strategy(int max_walls = 0,
                                                Coord transition_length_nm = 400'000) {
  StrategyOptions options;
  options.max_walls = max_walls;
  options.transition_length_nm = transition_length_nm;
  return MakeStrategy(options);
}

struct Plan {
  SkeletalGraph graph;
  std::vector<char> central;
  std::vector<BeadCount> counts;

  double XMm(size_t node) const {
    return (graph.nodes[node].place.x() + static_cast<double>(graph.origin.x)) / kNmPerMm;
  }
  double YMm(size_t node) const {
    return (graph.nodes[node].place.y() + static_cast<double>(graph.origin.y)) / kNmPerMm;
  }
  int HighestCount() const {
    int highest = -1;
    for (const BeadCount& count : counts) highest = std::max(highest, count.count);
    return highest;
  }
  /// Returns the nodes where the number of beads is not an integer.
  std::vector<size_t> InTransition() const {
    std::vector<size_t> nodes;
    for (size_t i = 0; i < counts.size(); ++i)
      if (counts[i].ratio != 0) nodes.push_back(i);
    return nodes;
  }
  size_t Widest() const {
    const auto widest = std::ranges::max_element(graph.nodes, {}, &SkeletalNode::radius);
    return static_cast<size_t>(widest - graph.nodes.begin());
  }
};

Plan PlanOf(const PolygonWithHoles& region, const BeadingStrategy& strategy,
            const CountOptions& options = {}) {
  Plan plan;
  plan.graph = *MakeSkeletalGraph(*MakeBoundary(region), {.step_nm = 200'000});
  plan.central = CentralEdges(plan.graph, {});
  plan.counts = PlanBeadCounts(strategy, options, plan.graph, plan.central);
  EXPECT_EQ(plan.counts.size(), plan.graph.nodes.size());
  EXPECT_EQ(plan.central.size(), plan.graph.half_edges.size() / 2);
  return plan;
}

Plan PlanOf(std::string_view text, const BeadingStrategy& strategy,
            const CountOptions& options = {}) {
  return PlanOf(MakePolygonsOrDie(text)[0], strategy, options);
}

struct StripCase {
  int max_walls;
  std::string thickness_mm;
  int count;
};
class StripCounts : public testing::TestWithParam<StripCase> {};

TEST_P(StripCounts, AreThoseOfItsThickness) {
  const StripCase& strip = GetParam();
  const std::string& y = strip.thickness_mm;
  const auto strategy = Strategy(strip.max_walls);
  const Plan plan = PlanOf("(0 0, 20 0, 20 " + y + ", 0 " + y + ")", *strategy);
  int decided = 0;
  for (size_t node = 0; node < plan.counts.size(); ++node) {
    if (plan.graph.nodes[node].radius == 0) {
      EXPECT_FALSE(plan.counts[node].decided()) << "corner";
      continue;
    }
    ++decided;
    EXPECT_EQ(plan.counts[node], (BeadCount{strip.count, 0}));
  }
  EXPECT_EQ(decided, 2);
}

INSTANTIATE_TEST_SUITE_P(BeadCounts, StripCounts,
                         testing::Values(StripCase{0, "0.05", 0}, StripCase{0, "0.3", 1},
                                         StripCase{0, "0.678", 1}, StripCase{0, "0.682", 2},
                                         StripCase{0, "1.138", 2}, StripCase{0, "1.142", 3},
                                         StripCase{0, "1.482", 4}, StripCase{0, "8", 20},
                                         StripCase{2, "1.482", 4}, StripCase{2, "1.988", 4},
                                         StripCase{2, "1.992", 5}, StripCase{2, "8", 5}),
                         [](const auto& info) {
                           std::string name = "Walls" + std::to_string(info.param.max_walls) + "Mm";
                           for (const char c : info.param.thickness_mm) name += c == '.' ? '_' : c;
                           return name;
                         });

/// Region that is 0.3 mm thick up to x = 4 and 1 mm from x = 9.
constexpr std::string_view kStepped =
    "(0 0, 4 0, 9 -0.35, 13 -0.35, 13 0.65, 9 0.65, 4 0.3, 0 0.3)";

TEST(BeadCounts, AStepIsATransitionAtItsThickness) {
  const auto strategy = Strategy();
  const Plan plan = PlanOf(kStepped, *strategy);
  const auto nodes = plan.InTransition();
  ASSERT_EQ(nodes.size(), 1u);
  const size_t at = nodes[0];
  EXPECT_NEAR(plan.graph.nodes[at].radius * 2, strategy->TransitionThickness(1), 100);
  EXPECT_EQ(plan.counts[at].count, 1);
  EXPECT_NEAR(plan.counts[at].ratio, strategy->TransitionAnchor(1), 1e-9);
  EXPECT_GT(plan.counts[at].ratio, 0);
  EXPECT_LT(plan.counts[at].ratio, 1);
}

TEST(BeadCounts, ATransitionIsAsLongAsTheStrategySays) {
  for (const Coord length_nm : {400'000, 1'000'000}) {
    const auto strategy = Strategy(0, length_nm);
    const Plan plan = PlanOf(kStepped, *strategy);
    const auto nodes = plan.InTransition();
    ASSERT_FALSE(nodes.empty());
    // The transition is between the last node with one bead and the first one with two.
    double from = -1e9, to = 1e9;
    for (size_t i = 0; i < plan.counts.size(); ++i) {
      if (plan.counts[i] == BeadCount{1, 0}) from = std::max(from, plan.XMm(i));
      if (plan.counts[i] == BeadCount{2, 0}) to = std::min(to, plan.XMm(i));
    }
    EXPECT_NEAR(to - from, length_nm / 1e6, 0.001);
    for (const size_t node : nodes) {
      const double ratio = (plan.XMm(node) - from) / (to - from);
      EXPECT_NEAR(plan.counts[node].ratio, ratio, 0.001);
    }
  }
}

/// Strip 0.64 mm thick, slightly more than 0.68 mm around x = 5: two beads there are 0.02 mm wider
/// than when they split.
constexpr std::string_view kBump = "(0 0, 10 0, 10 0.64, 7 0.64, 5 0.7, 3 0.64, 0 0.64)";

TEST(BeadCounts, ASmallBumpMakesNoTransition) {
  const auto strategy = Strategy();
  const Plan filtered = PlanOf(kBump, *strategy);
  EXPECT_EQ(filtered.HighestCount(), 1);
  EXPECT_TRUE(filtered.InTransition().empty());
  const Plan plain = PlanOf(kBump, *strategy, {.filter_deviation_nm = 1'000});
  EXPECT_EQ(plain.HighestCount(), 2);
  EXPECT_EQ(plain.InTransition().size(), 2u);
}

// The bump has two beads along 1.3 mm.
TEST(BeadCounts, ALongBumpIsNotFiltered) {
  const auto strategy = Strategy();
  EXPECT_EQ(PlanOf(kBump, *strategy, {.filter_distance_nm = 1'200'000}).HighestCount(), 2);
  EXPECT_EQ(PlanOf(kBump, *strategy, {.filter_distance_nm = 1'400'000}).HighestCount(), 1);
}

/// Returns a strip of 0.4 mm that widens to `thickness_mm` and has this thickness over half a mm.
std::string Club(double thickness_mm) {
  const double by = (thickness_mm - 0.4) / 2;
  const double taper = by / 0.08;
  const auto point = [](double x, double y) { return std::to_string(x) + " " + std::to_string(y); };
  return "(0 0, 9 0, " + point(9 + taper, -by) + ", " + point(9.5 + taper, -by) + ", " +
         point(9.5 + taper, 0.4 + by) + ", " + point(9 + taper, 0.4 + by) + ", 9 0.4, 0 0.4)";
}

// A transition of 9 mm does not fit in the club's head. For this reason beads may deviate up to
// three times as much as the filter allows.
TEST(BeadCounts, AWidePartIsNotDissolvedForWantOfRoom) {
  const auto strategy = Strategy(0, 9'000'000);
  const Plan slight = PlanOf(Club(0.90), *strategy);
  EXPECT_EQ(slight.HighestCount(), 1);
  EXPECT_TRUE(slight.InTransition().empty());
  const Plan thick = PlanOf(Club(1.05), *strategy);
  ASSERT_FALSE(thick.InTransition().empty());
  const BeadCount top = thick.counts[thick.Widest()];
  EXPECT_EQ(top.count, 1);
  EXPECT_GT(top.ratio, strategy->TransitionAnchor(1));
}

TEST(BeadCounts, AHeadHasTheCountOfItsThickness) {
  const auto strategy = Strategy();
  for (const double thickness_mm : {0.9, 1.05, 2., 4.}) {
    const Plan plan = PlanOf(Club(thickness_mm), *strategy, {.filter_deviation_nm = 1'000});
    const size_t top = plan.Widest();
    const auto thickness = static_cast<Coord>(std::llround(2 * plan.graph.nodes[top].radius));
    EXPECT_EQ(plan.counts[top], (BeadCount{strategy->OptimalCount(thickness), 0})) << thickness_mm;
  }
}

struct TopCase {
  std::string name;
  std::string text;
};
class LoneTop : public testing::TestWithParam<TopCase> {};

TEST_P(LoneTop, HasItsCountWithoutADot) {
  const auto strategy = Strategy();
  const Plan plan = PlanOf(GetParam().text, *strategy);
  const size_t top = plan.Widest();
  const auto thickness = static_cast<Coord>(std::llround(2 * plan.graph.nodes[top].radius));
  const int optimal = strategy->OptimalCount(thickness);
  EXPECT_EQ(plan.counts[top].count, optimal - optimal % 2);
}

// In the second case the top is on a central line of 30 um; in the last case the tail is central
// too.
INSTANTIATE_TEST_SUITE_P(
    BeadCounts, LoneTop,
    testing::Values(TopCase{"Square", "(0 0, 5 0, 5 5, 0 5)"},
                    TopCase{"AlmostASquare", "(0 0, 5.03 0, 5.03 5, 0 5)"},
                    TopCase{"Triangle", "(0 0, 6 0, 2 5)"},
                    TopCase{"SquareWithATail", "(0 0, 5 0, 5 2.3, 9 2.3, 9 2.7, 5 2.7, 5 5, 0 5)"}),
    [](const auto& info) { return info.param.name; });

struct SquareCase {
  std::string name;
  int max_walls;
  Coord side_nm;
  int count;
};
class SquareTop : public testing::TestWithParam<SquareCase> {};

TEST_P(SquareTop, HasThisCount) {
  const Coord side = GetParam().side_nm;
  const PolygonWithHoles square = {{{0, 0}, {side, 0}, {side, side}, {0, side}}, {}};
  const Plan plan = PlanOf(square, *Strategy(GetParam().max_walls));
  EXPECT_EQ(plan.counts[plan.Widest()].count, GetParam().count);
}

// Beads are 0.4 mm wide. With at most four beads, five means that the middle belongs to the infill.
INSTANTIATE_TEST_SUITE_P(BeadCounts, SquareTop,
                         testing::Values(SquareCase{"OneIsAllThereIs", 0, 400'000, 1},
                                         SquareCase{"TheOutermostKeepTheirWidth", 0, 1'200'000, 3},
                                         SquareCase{"FourInsteadOfFive", 0, 2'000'000, 4},
                                         SquareCase{"Six", 0, 2'400'000, 6},
                                         SquareCase{"SixInsteadOfSeven", 0, 2'800'000, 6},
                                         SquareCase{"SixInsteadOfSevenInTheEnd", 3, 2'750'000, 6},
                                         SquareCase{"WallsTakeASmallMiddle", 2, 2'300'000, 4},
                                         SquareCase{"InfillInTheMiddle", 2, 2'700'000, 5}),
                         [](const auto& info) { return info.param.name; });

/// Returns two squares connected by a neck 2 mm thick, which is five beads wide.
std::string Dumbbell(double neck_mm) {
  const auto point = [&](double x, int y) {
    return std::to_string(x) + " " + std::to_string(y) + ", ";
  };
  const double to = 6 + neck_mm, end = 12 + neck_mm;
  return "(0 0, 6 0, 6 2, " + point(to, 2) + point(to, 0) + point(end, 0) + point(end, 6) +
         point(to, 6) + point(to, 4) + "6 4, 6 6, 0 6)";
}

TEST(BeadCounts, AShortNeckHasNoMiddleBead) {
  const auto strategy = Strategy(3);
  for (const auto& [neck_mm, has_middle] : {std::pair(0.6, false), {3.0, true}}) {
    const Plan plan = PlanOf(Dumbbell(neck_mm), *strategy);
    EXPECT_EQ(std::ranges::count(plan.counts, BeadCount{5, 0}) > 0, has_middle) << neck_mm;
    EXPECT_EQ(plan.HighestCount(), 7);
  }
}

TEST(BeadCounts, AreMirroredWithTheRegion) {
  constexpr std::string_view kParts[] = {kStepped, kBump,
                                         "(0 0, 6 0.3, 6 2, 5.5 2, 5.4 0.9, 0.4 0.6, 0.5 4, 0 4)"};
  const auto strategy = Strategy();
  for (const std::string_view text : kParts) {
    const PolygonWithHoles region = MakePolygonsOrDie(text)[0];
    PolygonWithHoles mirrored = region;
    for (Point& p : mirrored.outer) p.x = -p.x;
    std::reverse(mirrored.outer.begin(), mirrored.outer.end());
    const CountOptions options = {.filter_deviation_nm = 10'000};
    const Plan a = PlanOf(region, *strategy, options), b = PlanOf(mirrored, *strategy, options);
    ASSERT_EQ(a.counts.size(), b.counts.size()) << text;
    for (size_t i = 0; i < a.counts.size(); ++i) {
      const auto same = [&](size_t j) {
        return std::abs(a.XMm(i) + b.XMm(j)) < 0.003 && std::abs(a.YMm(i) - b.YMm(j)) < 0.003 &&
               a.counts[i].count == b.counts[j].count &&
               std::abs(a.counts[i].ratio - b.counts[j].ratio) < 0.01;
      };
      bool found = false;
      for (size_t j = 0; j < b.counts.size() && !found; ++j) found = same(j);
      EXPECT_TRUE(found) << text << ": " << a.XMm(i) << " " << a.YMm(i);
    }
  }
}

}  // namespace
}  // namespace slicefarm::beading::bead_counts_test
