#include "common/geometry/skeleton/skeletal_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "common/geometry/text_format_test.h"

namespace slicefarm::skeletal_graph_test {
namespace {

constexpr double kErrorNm = 2'000;

PolygonWithHoles Region(std::string_view text) { return MakePolygonsOrDie(text)[0]; }

SkeletalGraph GraphOf(const PolygonWithHoles& region, const SkeletalOptions& options = {}) {
  const auto boundary = MakeBoundary(region);
  EXPECT_TRUE(boundary.has_value());
  if (!boundary) return {};
  auto graph = MakeSkeletalGraph(*boundary, options);
  EXPECT_TRUE(graph.has_value());
  return graph ? *std::move(graph) : SkeletalGraph{};
}

// --- shapes
// ----------------------------------------------------------------------------------------

/// Returns a ring with corners at `radius_mm(i)` that turns once around the centre.
template <typename Radius>
Polygon Around(double x_mm, double y_mm, int corners, const Radius& radius_mm) {
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * std::numbers::pi * i / corners;
    ring.push_back({FromMm(x_mm + radius_mm(i) * std::cos(turn)),
                    FromMm(y_mm + radius_mm(i) * std::sin(turn))});
  }
  return ring;
}

Polygon Circle(double x_mm, double y_mm, int corners, double radius_mm) {
  return Around(x_mm, y_mm, corners, [=](int) { return radius_mm; });
}

Polygon Hole(Polygon ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

PolygonWithHoles Comb(int teeth) {
  PolygonWithHoles comb;
  comb.outer = {{0, 0}, {FromMm(teeth), 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    comb.outer.push_back({FromMm(i + 1.0), FromMm(5)});
    comb.outer.push_back({FromMm(i + 0.5), FromMm(5)});
    comb.outer.push_back({FromMm(i + 0.5), FromMm(1)});
    comb.outer.push_back({FromMm(i), FromMm(1)});
  }
  return comb;
}

struct ShapeCase {
  std::string name;
  PolygonWithHoles region;
};

std::vector<ShapeCase> Shapes() {
  return {
      {"Square", Region("(0 0, 2 0, 2 2, 0 2)")},
      {"Rectangle", Region("(0 0, 5 0, 5 1, 0 1)")},
      {"Triangle", Region("(0 0, 4 0, 1 3)")},
      {"L", Region("(0 0, 4 0, 4 1, 1 1, 1 4, 0 4)")},
      {"Star", {Around(0, 0, 14, [](int i) { return i % 2 == 0 ? 10 : 1.5; }), {}}},
      {"PlateWithRoundHole",
       {Region("(0 0, 20 0, 20 20, 0 20)").outer, {Hole(Circle(10, 9, 64, 4))}}},
      {"PlateWithTwoHoles",
       Region("(0 0, 9 0, 9 3, 5 3, 5.5 8, 1 7, 3 4) (6 1, 8 1, 7 2) (2 6, 4 6, 4 7)")},
      {"Comb", Comb(12)},
      {"SliverWedge", Region("(0 0, 10 -0.05, 10 0.05)")},
      {"RingOfAThousandVertices", {Circle(0, 0, 500, 8), {Hole(Circle(0, 0, 500, 7.5))}}},
      {"WavyDiscOfAThousandVertices",
       {Around(0, 0, 1'000, [](int i) { return 10 + 0.3 * std::sin(0.4 * i); }), {}}},
  };
}

// --- required properties
// ---------------------------------------------------------------------------

double Distance(Vector2 a, Vector2 b) { return std::hypot(b.x() - a.x(), b.y() - a.y()); }

double DistanceToSegment(Vector2 p, Vector2 a, Vector2 b) {
  const double dx = b.x() - a.x(), dy = b.y() - a.y();
  const double t =
      std::clamp(((p.x() - a.x()) * dx + (p.y() - a.y()) * dy) / (dx * dx + dy * dy), 0., 1.);
  return Distance(p, {a.x() + t * dx, a.y() + t * dy});
}

void ExpectRadiiAreDistances(const SkeletalGraph& graph, const PolygonWithHoles& region,
                             double error_nm) {
  for (const SkeletalNode& node : graph.nodes) {
    double distance = std::numeric_limits<double>::infinity();
    for (const Polygon& ring : Rings({region})) {
      for (size_t i = 0; i < ring.size(); ++i) {
        const Vector2 from = ToVector(ring[i] - graph.origin);
        const Vector2 to = ToVector(ring[(i + 1) % ring.size()] - graph.origin);
        distance = std::min(distance, DistanceToSegment(node.place, from, to));
      }
    }
    ASSERT_NEAR(node.radius, distance, error_nm) << node.place.x() << " " << node.place.y();
  }
}

/// Checks that half-edges join, that each is on one walk and starts in one node, that there is one
/// walk per ring, and one cycle per hole.
void ExpectConsistent(const SkeletalGraph& graph, int holes) {
  const int halves = static_cast<int>(graph.half_edges.size());
  const int nodes = static_cast<int>(graph.nodes.size());
  ASSERT_GT(halves, 0);
  ASSERT_EQ(halves % 2, 0);
  for (int half = 0; half < halves; ++half) {
    const HalfEdge& edge = graph.half_edges[half];
    ASSERT_TRUE(0 <= edge.next && edge.next < halves);
    ASSERT_TRUE(0 <= edge.from && edge.from < nodes);
    ASSERT_EQ(graph.half_edges[edge.next].previous, half);
    ASSERT_EQ(graph.half_edges[edge.next].from, graph.To(half));
    ASSERT_EQ(graph.half_edges[half ^ 1].from, graph.To(half));
    ASSERT_EQ(graph.To(half ^ 1), edge.from);
  }
  EXPECT_EQ(halves / 2 - nodes + 1, holes);

  std::vector<char> seen(halves);
  int paths = 0;
  for (int half = 0; half < halves; ++half) {
    paths += !seen[half];
    for (int at = half; !seen[at]; at = graph.half_edges[at].next) seen[at] = true;
  }
  EXPECT_EQ(paths, holes + 1);

  int visited = 0;
  const std::vector<int> leaving = graph.Leaving();
  for (int node = 0; node < nodes; ++node) {
    ASSERT_GE(leaving[node], 0);
    graph.ForEachLeaving(leaving[node], [&](int half) {
      ASSERT_EQ(graph.half_edges[half].from, node);
      ++visited;
    });
  }
  EXPECT_EQ(visited, halves);
}

/// Checks that each edge of the boundary and each reflex corner has one contiguous part of the
/// walk, in their order.
void ExpectFeaturesInOrder(const SkeletalGraph& graph) {
  int changes = 0;
  std::set<std::pair<int, bool>> features;
  for (const HalfEdge& edge : graph.half_edges) {
    features.emplace(edge.feature, edge.is_corner);
    const HalfEdge& next = graph.half_edges[edge.next];
    if (edge.feature == next.feature && edge.is_corner == next.is_corner) continue;
    ++changes;
    if (next.is_corner) {
      EXPECT_EQ(next.feature, edge.feature);
    } else {
      EXPECT_EQ(next.feature, graph.boundary[edge.feature].previous);
    }
  }
  EXPECT_EQ(changes, static_cast<int>(features.size()));
  for (int edge = 0; edge < static_cast<int>(graph.boundary.size()); ++edge) {
    const BoundaryEdge& at = graph.boundary[edge];
    const Point in = at.from - graph.boundary[at.previous].from;
    EXPECT_TRUE(features.contains({edge, false})) << edge;
    EXPECT_EQ(features.contains({edge, true}), Cross(in, at.to - at.from) < 0) << edge;
  }
}

void ExpectFeet(const SkeletalGraph& graph, double error_nm) {
  for (int half = 0; half < static_cast<int>(graph.half_edges.size()); ++half) {
    const BoundaryEdge& feature = graph.boundary[graph.half_edges[half].feature];
    for (const SkeletalNode& node : {graph.FromNode(half), graph.ToNode(half)}) {
      const Vector2 foot = graph.Foot(half, node);
      ASSERT_NEAR(Distance(foot, node.place), node.radius, error_nm) << half;
      if (graph.half_edges[half].is_corner) {
        ASSERT_EQ(Distance(foot, ToVector(feature.from)), 0) << half;
      } else {
        ASSERT_LT(DistanceToSegment(foot, ToVector(feature.from), ToVector(feature.to)), 1) << half;
      }
    }
  }
}

class SkeletalShape : public testing::TestWithParam<ShapeCase> {
 protected:
  const PolygonWithHoles& region_ = GetParam().region;
  const int holes_ = static_cast<int>(region_.holes.size());
  const SkeletalGraph graph_ = GraphOf(region_);
};

TEST_P(SkeletalShape, RadiiAreDistancesToTheBoundary) {
  ASSERT_FALSE(graph_.nodes.empty());
  ExpectRadiiAreDistances(graph_, region_, kErrorNm);
}

TEST_P(SkeletalShape, HalfEdgesJoin) { ExpectConsistent(graph_, holes_); }

TEST_P(SkeletalShape, FeaturesFollowEachOtherAgainstTheRing) { ExpectFeaturesInOrder(graph_); }

TEST_P(SkeletalShape, FeetLieOnTheirFeatures) { ExpectFeet(graph_, kErrorNm); }

TEST_P(SkeletalShape, ConvexCornersAreNodes) {
  ASSERT_FALSE(graph_.boundary.empty());
  for (const BoundaryEdge& edge : graph_.boundary) {
    const Point in = edge.from - graph_.boundary[edge.previous].from;
    const auto ends = std::ranges::count_if(graph_.nodes, [&](const SkeletalNode& node) {
      return node.radius == 0 && Distance(node.place, ToVector(edge.from)) == 0;
    });
    EXPECT_EQ(ends, Cross(in, edge.to - edge.from) > 0 ? 1 : 0) << ToText(edge.from);
  }
}

TEST_P(SkeletalShape, SplittingEveryEdgeKeepsAllThis) {
  const SkeletalOptions options;
  SkeletalGraph graph = graph_;
  for (int half = 0; half < static_cast<int>(graph_.half_edges.size()); half += 2) {
    // Splits the twin of every second edge, so that both directions are tested.
    const int split = half % 4 == 0 ? half : half ^ 1;
    const SkeletalNode from = graph.FromNode(split), to = graph.ToNode(split);
    const int end = graph.To(split);
    const int added = static_cast<int>(graph.nodes.size());
    const int onward = graph.Split(split, {{std::lerp(from.place.x(), to.place.x(), 0.3),
                                            std::lerp(from.place.y(), to.place.y(), 0.3)},
                                           std::lerp(from.radius, to.radius, 0.3)});
    ASSERT_EQ(graph.To(split), added);
    ASSERT_EQ(graph.half_edges[onward].from, added);
    ASSERT_EQ(graph.To(onward), end);
    ASSERT_EQ(graph.half_edges[split].next, onward);
  }
  EXPECT_EQ(graph.half_edges.size(), 2 * graph_.half_edges.size());
  EXPECT_EQ(graph.nodes.size(), graph_.nodes.size() + graph_.half_edges.size() / 2);
  ExpectConsistent(graph, holes_);
  ExpectFeaturesInOrder(graph);
  // In the middle of a chord, the corner is nearer than the radius by twice the deviation of the
  // chord.
  ExpectRadiiAreDistances(graph, region_, kErrorNm + 2 * options.tolerance_nm);
  ExpectFeet(graph, kErrorNm + 2 * options.tolerance_nm);
}

TEST_P(SkeletalShape, IsTheSameEachTime) {
  const SkeletalGraph again = GraphOf(region_);
  ASSERT_EQ(again.nodes.size(), graph_.nodes.size());
  ASSERT_EQ(again.half_edges.size(), graph_.half_edges.size());
  for (size_t i = 0; i < graph_.nodes.size(); ++i) {
    const SkeletalNode &a = graph_.nodes[i], &b = again.nodes[i];
    ASSERT_TRUE(a.place.x() == b.place.x() && a.place.y() == b.place.y() && a.radius == b.radius)
        << i;
  }
  for (size_t i = 0; i < graph_.half_edges.size(); ++i) {
    const HalfEdge &a = graph_.half_edges[i], &b = again.half_edges[i];
    ASSERT_TRUE(a.from == b.from && a.next == b.next && a.feature == b.feature &&
                a.is_corner == b.is_corner)
        << i;
  }
}

INSTANTIATE_TEST_SUITE_P(SkeletalGraph, SkeletalShape, testing::ValuesIn(Shapes()),
                         [](const auto& info) { return info.param.name; });

// --- curves
// ----------------------------------------------------------------------------------------

/// A reflex corner 1 mm above a flat floor.
constexpr std::string_view kCornerOverFloor = "(0 0, 8 0, 8 6, 4 1, 0 6)";

/// Returns half of the difference of the distances to the two features of an edge. This is about
/// the distance of the point from the curve between them.
double OffCurve(const SkeletalGraph& graph, int half, double t) {
  const Vector2 a = graph.FromNode(half).place, b = graph.ToNode(half).place;
  const SkeletalNode node = {{std::lerp(a.x(), b.x(), t), std::lerp(a.y(), b.y(), t)}, 0};
  const double left = Distance(node.place, graph.Foot(half, node));
  const double right = Distance(node.place, graph.Foot(half ^ 1, node));
  return std::abs(left - right) / 2;
}

TEST(SkeletalGraph, ChordsOfAParabolaStayWithinTheTolerance) {
  double before = 0;
  for (const double tolerance : {1'000., 10'000., 50'000.}) {
    const SkeletalGraph graph =
        GraphOf(Region(kCornerOverFloor), {.tolerance_nm = tolerance, .step_nm = 1e9});
    double worst = 0;
    for (int half = 0; half < static_cast<int>(graph.half_edges.size()); half += 2)
      for (const double t : {0.25, 0.5, 0.75}) worst = std::max(worst, OffCurve(graph, half, t));
    EXPECT_LT(worst, 1.01 * tolerance);
    // Chords are nearly as long as the tolerance allows.
    EXPECT_GT(worst, tolerance / 4);
    EXPECT_GT(worst, before);
    before = worst;
  }
}

TEST(SkeletalGraph, ChordsAreNoLongerThanTheStep) {
  for (const double step : {100'000., 300'000.}) {
    const SkeletalGraph graph =
        GraphOf(Region(kCornerOverFloor), {.tolerance_nm = 1e9, .step_nm = step});
    for (int half = 0; half < static_cast<int>(graph.half_edges.size()); half += 2) {
      const bool curved = graph.half_edges[half].is_corner != graph.half_edges[half ^ 1].is_corner;
      if (!curved) continue;
      const double along = std::abs(graph.FromNode(half).place.x() - graph.ToNode(half).place.x());
      EXPECT_LT(along, step + 10'000);
    }
  }
}

// A chord across such a position would be central as a whole or not at all.
TEST(SkeletalGraph, ChordsEndWhereCentralityChanges) {
  const double angle = 0.4;
  const SkeletalGraph graph = GraphOf(
      Region(kCornerOverFloor), {.tolerance_nm = 1e9, .step_nm = 1e9, .transition_angle = angle});
  const double from_corner = kNmPerMm * std::tan(angle / 2);
  for (const double side : {-1., 1.}) {
    const double x = static_cast<double>(4 * kNmPerMm - graph.origin.x) + side * from_corner;
    EXPECT_EQ(
        std::ranges::count_if(graph.nodes,
                              [&](const SkeletalNode& n) { return std::abs(n.place.x() - x) < 2; }),
        1)
        << side;
  }
}

TEST(SkeletalGraph, BetweenTwoCornersTheNarrowestPlaceIsANode) {
  const SkeletalGraph graph = GraphOf(Region("(0 0, 4 0.8, 8 0, 8 2, 4 1.2, 0 2)"));
  const auto least = std::ranges::count_if(graph.nodes, [](const SkeletalNode& node) {
    return std::abs(node.radius - 200'000) < 10 && std::abs(node.place.x()) < 10;
  });
  EXPECT_EQ(least, 1);
}

}  // namespace
}  // namespace slicefarm::skeletal_graph_test
