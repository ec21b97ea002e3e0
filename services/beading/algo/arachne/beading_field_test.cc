#include "services/beading/algo/arachne/beading_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/geometry/text_format_test.h"
#include "services/beading/algo/skeleton/centrality.h"
#include "services/beading/algo/strategy/strategy_factory.h"

namespace slicefarm::beading::beading_field_test {
namespace {

constexpr BeadCount kOne = {1, 0}, kTwo = {2, 0}, kOpen = {};

struct Node {
  Vector2 place = Vector2::Zero();
  double radius;
  BeadCount count;
};

struct Field {
  SkeletalGraph graph;
  std::vector<BeadCount> counts;
  std::vector<char> central;
  std::vector<NodeBeading> beadings;
};

/// Returns a tree with these edges, in this order around each node.
SkeletalGraph Tree(const std::vector<Node>& nodes, const std::vector<std::pair<int, int>>& edges) {
  SkeletalGraph graph;
  std::vector<std::vector<int>> leaving(nodes.size());
  for (const Node& node : nodes) graph.nodes.push_back({node.place, node.radius});
  for (const auto& [from, to] : edges) {
    for (const int node : {from, to}) {
      leaving[node].push_back(static_cast<int>(graph.half_edges.size()));
      graph.half_edges.push_back({.from = node});
    }
  }
  for (const std::vector<int>& around : leaving) {
    for (size_t i = 0; i < around.size(); ++i) {
      const int arriving = around[i] ^ 1, onward = around[(i + 1) % around.size()];
      graph.half_edges[arriving].next = onward;
      graph.half_edges[onward].previous = arriving;
    }
  }
  return graph;
}

Field FieldOf(const std::vector<Node>& nodes, const std::vector<std::pair<int, int>>& edges,
              double transition_length_nm = 400'000) {
  Field field;
  field.graph = Tree(nodes, edges);
  for (const Node& node : nodes) field.counts.push_back(node.count);
  field.central.assign(edges.size(), 0);
  field.central[0] = 1;
  field.beadings = BeadingField(*MakeStrategy({}), transition_length_nm, field.graph, field.counts,
                                field.central);
  EXPECT_EQ(field.beadings.size(), field.graph.nodes.size());
  EXPECT_EQ(field.counts.size(), field.graph.nodes.size());
  EXPECT_EQ(field.central.size(), field.graph.half_edges.size() / 2);
  return field;
}

/// Returns the field of a chain that connects each node to the next one.
Field ChainOf(const std::vector<Node>& nodes, double transition_length_nm = 400'000) {
  std::vector<std::pair<int, int>> edges;
  for (int i = 0; i + 1 < static_cast<int>(nodes.size()); ++i) edges.emplace_back(i, i + 1);
  return FieldOf(nodes, edges, transition_length_nm);
}

void ExpectSide(const NodeBeading& beading, double width, double location) {
  EXPECT_FALSE(beading.has_middle);
  ASSERT_EQ(beading.sides.size(), 1u);
  EXPECT_NEAR(beading.sides[0].width, width, 0.001);
  EXPECT_NEAR(beading.sides[0].location, location, 0.001);
}

const NodeBeading kTwoOf400 = {{{400'000, 200'000}}, false, 0};

TEST(BeadingField, DecidedNodesHaveWhatIsLaidOut) {
  const Field field =
      ChainOf({{{0, 0}, 200'000, kOne}, {{1e6, 0}, 400'000, kTwo}, {{2e6, 0}, 600'000, {2, 0.5}}});
  ASSERT_EQ(field.beadings.size(), 3u);
  EXPECT_EQ(field.beadings[0], (NodeBeading{{}, true, 400'000}));
  EXPECT_EQ(field.beadings[1], kTwoOf400);
  // The node is halfway from two beads of 0.6 mm to three of 0.4 mm.
  EXPECT_EQ(field.beadings[2], (NodeBeading{{{500'000, 250'000}}, true, 200'000}));
}

TEST(BeadingField, NodesBelowADecidedOneInheritItsBeads) {
  const Field field =
      ChainOf({{{0, 0}, 0, kOpen}, {{2e6, 0}, 200'000, kOpen}, {{4e6, 0}, 400'000, kTwo}});
  ASSERT_EQ(field.beadings.size(), 3u);
  EXPECT_EQ(field.beadings[0], kTwoOf400);
  EXPECT_EQ(field.beadings[1], kTwoOf400);
}

TEST(BeadingField, OfTwoWaysUpTheSteeperOneCounts) {
  const Field field = FieldOf({{{0, 0}, 100'000, kOpen},
                               {{1e6, 0}, 300'000, kOne},
                               {{0, 1e6}, 400'000, kTwo},
                               {{-3e6, 0}, 600'000, kOne}},
                              {{0, 1}, {0, 2}, {0, 3}});
  EXPECT_EQ(field.beadings[0], kTwoOf400);
}

// Nodes above all decided nodes have no bead to take over.
TEST(BeadingField, NodesWithNoWayUpStayEmpty) {
  const Field field = ChainOf({{{0, 0}, 200'000, kOne}, {{100'000, 0}, 300'000, kOpen}});
  ASSERT_EQ(field.beadings.size(), 2u);
  EXPECT_EQ(field.beadings[1], NodeBeading{});
}

// One bead of 0.4 mm counts as two of 0.2 mm side by side; a quarter of the change to two of 0.4 mm
// follows.
TEST(BeadingField, NodesAboveADecidedOneBlend) {
  const Field field = ChainOf({{{0, 0}, 200'000, kOne},
                               {{100'000, 0}, 300'000, kOpen},
                               {{400'000, 0}, 380'000, kOpen},
                               {{1e6, 0}, 400'000, kTwo}});
  ASSERT_EQ(field.beadings.size(), 4u);
  ExpectSide(field.beadings[1], 250'000, 125'000);
  EXPECT_EQ(field.beadings[2], kTwoOf400);
}

TEST(BeadingField, WithoutRoomTheBlendIsAsLongAsTheWay) {
  const Field field = ChainOf(
      {{{0, 0}, 200'000, kOne}, {{100'000, 0}, 300'000, kOpen}, {{200'000, 0}, 400'000, kTwo}});
  ASSERT_EQ(field.beadings.size(), 3u);
  ExpectSide(field.beadings[1], 300'000, 150'000);
}

TEST(BeadingField, OfTwoWaysDownTheShorterOneCounts) {
  const Field field = FieldOf({{{0, 0}, 300'000, kOpen},
                               {{-300'000, 0}, 200'000, kOne},
                               {{0, -200'000}, 180'000, kOne},
                               {{1e6, 0}, 400'000, kTwo}},
                              {{0, 1}, {0, 2}, {0, 3}});
  ExpectSide(field.beadings[0], (180'000 + 400'000) / 2., (90'000 + 200'000) / 2.);
}

struct LengthCase {
  double transition_length_nm;
  size_t nodes;
};
class BlendEnd : public testing::TestWithParam<LengthCase> {};

// The path rises along an edge of 1 mm, and 0.2 mm more to the top.
TEST_P(BlendEnd, IsWhereTheTransitionLengthEnds) {
  const double length = GetParam().transition_length_nm;
  const Field field = ChainOf(
      {{{0, 0}, 200'000, kOne}, {{1e6, 0}, 300'000, kOpen}, {{1.2e6, 0}, 400'000, kTwo}}, length);
  ASSERT_EQ(field.graph.nodes.size(), GetParam().nodes);
  const double ratio = std::min(1.0, 1e6 / std::min(1.2e6, length));
  ExpectSide(field.beadings[1], std::lerp(200'000, 400'000, ratio),
             std::lerp(100'000, 200'000, ratio));
  if (field.graph.nodes.size() == 3) return;
  EXPECT_DOUBLE_EQ(field.graph.nodes[3].place.x(), length);
  EXPECT_DOUBLE_EQ(field.graph.nodes[3].radius, 200'000 + 0.1 * length);
  EXPECT_FALSE(field.counts[3].decided());
  EXPECT_EQ(field.beadings[3], kTwoOf400);
  EXPECT_EQ(field.central, (std::vector<char>{1, 0, 1}));
}

INSTANTIATE_TEST_SUITE_P(BeadingField, BlendEnd,
                         testing::Values(LengthCase{9'000, 3}, LengthCase{11'000, 4},
                                         LengthCase{400'000, 4}, LengthCase{989'000, 4},
                                         LengthCase{991'000, 3}, LengthCase{2'000'000, 3}),
                         [](const auto& info) {
                           return std::to_string(std::llround(info.param.transition_length_nm));
                         });

TEST(BeadingField, ABlendEndsBeforeATopThatIsFarAway) {
  const Field field = ChainOf(
      {{{0, 0}, 200'000, kOne}, {{0.1e6, 0}, 250'000, kOpen}, {{5e6, 0}, 400'000, kTwo}}, 400'000);
  ASSERT_EQ(field.graph.nodes.size(), 4u);
  EXPECT_DOUBLE_EQ(field.graph.nodes[3].place.x(), 400'000);
  EXPECT_EQ(field.beadings[3], kTwoOf400);
}

// The edge is level: each end has a decided node below, and counts as the higher end seen from the
// other end.
TEST(BeadingField, ALevelEdgeIsSplitOnlyOnce) {
  const Field field = ChainOf({{{0, 0}, 100'000, kOne},
                               {{100'000, 0}, 200'000, kOpen},
                               {{1'100'000, 0}, 200'000, kOpen},
                               {{1'200'000, 0}, 100'000, kOne}});
  ASSERT_EQ(field.graph.nodes.size(), 5u);
  EXPECT_DOUBLE_EQ(field.graph.nodes[4].place.x(), 400'000);
  EXPECT_EQ(field.graph.half_edges.size(), 8u);
}

TEST(BeadingField, CoversTheGraphsOfOutlines) {
  const auto strategy = MakeStrategy({.max_walls = 2});
  for (const std::string_view text :
       {"(0 0, 4 0, 9 -0.35, 13 -0.35, 13 0.65, 9 0.65, 4 0.3, 0 0.3)",
        "(0 0, 20 0, 20 9, 27 9, 27 0, 40 0, 40 20, 27 20, 27 11.4, 20 11.4, 20 20, 0 20)",
        "(0 0, 6 0.3, 6 2, 5.5 2, 5.4 0.9, 0.4 0.6, 0.5 4, 0 4)",
        "(0 0, 20 0, 20 12, 0 12) (6 1, 14 2, 14 10, 6 10)"}) {
    SCOPED_TRACE(text);
    SkeletalGraph graph = *MakeSkeletalGraph(*MakeBoundary(MakePolygonsOrDie(text)[0]), {});
    std::vector<char> central = CentralEdges(graph, {});
    std::vector<BeadCount> counts = PlanBeadCounts(*strategy, {}, graph, central);
    const size_t before = graph.nodes.size();
    const auto beadings = BeadingField(*strategy, 400'000, graph, counts, central);
    ASSERT_EQ(beadings.size(), graph.nodes.size());
    ASSERT_EQ(counts.size(), graph.nodes.size());
    ASSERT_EQ(central.size(), graph.half_edges.size() / 2);
    for (size_t i = 0; i < beadings.size(); ++i) {
      EXPECT_NE(beadings[i], NodeBeading{}) << i;
      EXPECT_TRUE(i < before || !counts[i].decided()) << i;
      // The beads lie side by side, beginning at the outline.
      double edge = 0;
      for (const SideBead& bead : beadings[i].sides) {
        EXPECT_NEAR(bead.location - bead.width / 2, edge, 2) << i;
        edge = bead.location + bead.width / 2;
      }
    }
  }
}

}  // namespace
}  // namespace slicefarm::beading::beading_field_test
