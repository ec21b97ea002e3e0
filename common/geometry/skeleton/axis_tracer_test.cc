#include "common/geometry/skeleton/axis_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/skeleton/voronoi_axis.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::axis_tracer_test {
namespace {

constexpr double kErrorNm = 0.1;

PolygonWithHoles Region(std::string_view text) { return MakePolygonsOrDie(text)[0]; }

/// Measures of a medial axis that do not depend on the order of its parts.
struct Measures {
  double length = 0;  ///< sum of the straight distances along all edges
  double widest = 0;  ///< greatest radius
  int cycles = 0;
};

Measures MeasuresOf(const SkeletalGraph& axis) {
  Measures measures;
  const int halves = static_cast<int>(axis.half_edges.size());
  for (int half = 0; half < halves; half += 2) measures.length += axis.Length(half);
  for (const SkeletalNode& node : axis.nodes)
    measures.widest = std::max(measures.widest, node.radius);
  measures.cycles = halves / 2 - static_cast<int>(axis.nodes.size()) + 1;
  return measures;
}

double DistanceTo(const std::vector<BoundaryEdge>& edges, const Vector2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const BoundaryEdge& edge : edges) {
    const Vector2 from = ToVector(edge.from), along = ToVector(edge.to) - from;
    const double t = std::clamp(Dot(p - from, along) / Dot(along, along), 0.0, 1.0);
    least = std::min(least, Norm(p - from - t * along));
  }
  return least;
}

void ExpectRadiiAreDistances(const SkeletalGraph& axis, const Boundary& boundary) {
  const std::vector<BoundaryEdge> edges = boundary.EdgesInNm();
  ASSERT_FALSE(axis.nodes.empty());
  for (const SkeletalNode& node : axis.nodes)
    ASSERT_NEAR(DistanceTo(edges, node.place), node.radius, kErrorNm);
}

void ExpectLinked(const SkeletalGraph& axis) {
  for (int half = 0; half < static_cast<int>(axis.half_edges.size()); ++half) {
    const HalfEdge& edge = axis.half_edges[half];
    ASSERT_GE(edge.next, 0);
    ASSERT_EQ(axis.half_edges[edge.next].previous, half);
    ASSERT_EQ(axis.half_edges[edge.next].from, axis.To(half));
  }
}

// --- random regions, with the Voronoi diagram as oracle ------------------------------------------

using Random = std::mt19937;

Coord Pick(Random& random, int low, int high) {
  return low + static_cast<Coord>(random() % static_cast<uint32_t>(high - low + 1));
}

Polygon Rectangle(Coord x, Coord y, Coord width, Coord height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

Polygon Round(Point centre, double radius, int corners, double turn) {
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2 * std::numbers::pi * i / corners;
    ring.push_back(centre + Point{std::llround(radius * std::cos(angle)),
                                  std::llround(radius * std::sin(angle))});
  }
  return ring;
}

Polygon Triangle(Random& random, Coord size) {
  Polygon ring;
  for (int i = 0; i < 3; ++i)
    ring.push_back(
        {Pick(random, 0, static_cast<int>(size)), Pick(random, 0, static_cast<int>(size))});
  if (SignedArea(ring) < 0) std::swap(ring[0], ring[1]);
  return ring;
}

MultiPolygon Without(const std::vector<Polygon>& parts, const std::vector<Polygon>& holes) {
  return Difference(Union(parts, FillRule::kNonZero), Union(holes, FillRule::kNonZero));
}

/// Rectangles on a grid: many places have equal distances to four and more edges.
MultiPolygon Rectangles(Random& random, Coord unit) {
  std::vector<Polygon> parts, holes;
  const auto rectangle = [&](int greatest) {
    return Rectangle(unit * Pick(random, 0, 20), unit * Pick(random, 0, 20),
                     unit * Pick(random, 1, greatest), unit * Pick(random, 1, greatest));
  };
  for (int i = 0; i < 12; ++i) parts.push_back(rectangle(8));
  for (int i = 0; i < 7; ++i) holes.push_back(rectangle(4));
  return Without(parts, holes);
}

MultiPolygon SmallRectangles(Random& random) { return Rectangles(random, 1'000); }
MultiPolygon LargeRectangles(Random& random) { return Rectangles(random, 500'000); }

MultiPolygon Circles(Random& random) {
  std::vector<Polygon> parts, holes;
  const auto round = [&](int least, int greatest, int corners) {
    return Round({1'000 * Pick(random, 0, 20'000), 1'000 * Pick(random, 0, 20'000)},
                 1'000. * Pick(random, least, greatest), static_cast<int>(Pick(random, 3, corners)),
                 Pick(random, 0, 6));
  };
  for (int i = 0; i < 4; ++i) parts.push_back(round(500, 8'000, 120));
  for (int i = 0; i < 8; ++i) holes.push_back(round(100, 3'000, 60));
  return Without(parts, holes);
}

MultiPolygon Triangles(Random& random) {
  std::vector<Polygon> parts, holes;
  for (int i = 0; i < 10; ++i) parts.push_back(Triangle(random, 10'000'000));
  for (int i = 0; i < 5; ++i) holes.push_back(Triangle(random, 10'000'000));
  return Without(parts, holes);
}

/// A square with square or round holes in rows.
MultiPolygon Lattice(Random& random) {
  const int rows = static_cast<int>(Pick(random, 1, 6));
  const int corners = static_cast<int>(Pick(random, 4, 40));
  const Coord pitch = 1'000 * Pick(random, 300, 2'000), wall = 1'000 * Pick(random, 50, 250);
  std::vector<Polygon> holes;
  for (int i = 0; i < rows * rows; ++i) {
    const Coord x = i % rows * pitch + wall, y = i / rows * pitch + wall, side = pitch - wall;
    if (corners < 16)
      holes.push_back(Rectangle(x, y, side, side));
    else
      holes.push_back(
          Round({x + side / 2, y + side / 2}, static_cast<double>(side) / 2, corners, 0));
  }
  const Coord size = rows * pitch + wall;
  return Without({Rectangle(0, 0, size, size)}, holes);
}

MultiPolygon Star(Random& random) {
  const int tips = static_cast<int>(Pick(random, 3, 120));
  const double inner = 1'000. * Pick(random, 100, 20'000);
  const double outer = 1'000. * Pick(random, 1'000, 20'000);
  const Polygon in = Round({0, 0}, inner, 2 * tips, 0), out = Round({0, 0}, outer, 2 * tips, 0);
  Polygon ring;
  for (int i = 0; i < 2 * tips; ++i) ring.push_back(i % 2 == 0 ? in[i] : out[i]);
  return Without({ring}, {});
}

/// A disc with a rough edge and a hole near its centre.
MultiPolygon RoughDisc(Random& random) {
  const int corners = static_cast<int>(Pick(random, 10, 300));
  const double radius = 1'000. * Pick(random, 1'000, 20'000);
  const int rough = static_cast<int>(Pick(random, 0, 400));
  Polygon ring = Round({0, 0}, radius, corners, 0);
  for (Point& p : ring) {
    const double scale = 1 + 1e-4 * static_cast<double>(Pick(random, -rough, rough));
    p = {std::llround(static_cast<double>(p.x) * scale),
         std::llround(static_cast<double>(p.y) * scale)};
  }
  return Without({ring}, {Round({0, 0}, 0.3 * radius, corners / 2 + 3, 0.1)});
}

MultiPolygon Strips(Random& random) {
  std::vector<Polygon> parts;
  for (int i = 0; i < 6; ++i) {
    const double angle = static_cast<double>(Pick(random, 0, 1'000)) / 100;
    const double length = 1'000. * Pick(random, 2'000, 60'000);
    const double width = 1'000. * Pick(random, 2, 400);
    const Vector2 along(std::cos(angle), std::sin(angle));
    const Vector2 from(1e3 * static_cast<double>(Pick(random, 0, 50'000)),
                       1e3 * static_cast<double>(Pick(random, 0, 50'000)));
    const Vector2 across = width * TurnedLeft(along);
    parts.push_back({RoundedPoint(from), RoundedPoint(from + length * along),
                     RoundedPoint(from + length * along + across), RoundedPoint(from + across)});
  }
  return Union(parts, FillRule::kNonZero);
}

struct Kind {
  std::string name;
  MultiPolygon (*make)(Random&);
};

class RandomRegions : public testing::TestWithParam<Kind> {};

TEST_P(RandomRegions, HaveTheAxisOfTheVoronoiDiagram) {
  constexpr int kRegions = 60;
  int traced = 0, refused = 0;
  for (int seed = 0; seed < kRegions; ++seed) {
    Random random(seed);
    for (const PolygonWithHoles& island : GetParam().make(random)) {
      const auto boundary = MakeBoundary(island);
      if (!boundary) continue;
      const auto axis = TraceAxis(*boundary);
      const auto expected = ExactVoronoiAxis(*boundary);
      ASSERT_TRUE(expected.has_value()) << seed;
      ++(axis ? traced : refused);
      if (!axis) continue;
      const Measures found = MeasuresOf(*axis), right = MeasuresOf(*expected);
      EXPECT_NEAR(found.length, right.length, 1e-5 * right.length) << seed;
      EXPECT_NEAR(found.widest, right.widest, 10) << seed;
      EXPECT_EQ(found.cycles, boundary->Holes()) << seed;
      ExpectLinked(*axis);
      ExpectRadiiAreDistances(*axis, *boundary);
      ASSERT_FALSE(HasFailure()) << seed;
    }
  }
  EXPECT_GE(traced, kRegions * 9 / 10);
  EXPECT_LE(refused, kRegions / 20);
}

INSTANTIATE_TEST_SUITE_P(AxisTracer, RandomRegions,
                         testing::Values(Kind{"SmallRectangles", SmallRectangles},
                                         Kind{"LargeRectangles", LargeRectangles},
                                         Kind{"Circles", Circles}, Kind{"Triangles", Triangles},
                                         Kind{"Lattice", Lattice}, Kind{"Star", Star},
                                         Kind{"RoughDisc", RoughDisc}, Kind{"Strips", Strips}),
                         [](const auto& info) { return info.param.name; });

// --- single shapes -------------------------------------------------------------------------------

SkeletalGraph AxisOf(const PolygonWithHoles& region) {
  const auto boundary = MakeBoundary(region);
  EXPECT_TRUE(boundary.has_value());
  const auto axis = boundary ? TraceAxis(*boundary) : std::nullopt;
  EXPECT_TRUE(axis.has_value());
  return axis.value_or(SkeletalGraph{});
}

TEST(AxisTracer, EqualDistancesToFourEdgesAreOneNode) {
  const SkeletalGraph axis = AxisOf(Region("(0 0, 2 0, 2 2, 0 2)"));
  EXPECT_EQ(axis.nodes.size(), 5u);
  EXPECT_EQ(axis.half_edges.size(), 8u);
}

// The discs at both ends of the strip are empty. Neither touches the hole.
TEST(AxisTracer, AHoleBetweenTwoEmptyDiscsIsFound) {
  for (const char* hole : {"(9.9 0.4, 10 0.6, 10.1 0.4)", "(9.9 0.01, 10 0.02, 10.1 0.01)",
                           "(1.5 0.4, 1.6 0.6, 1.7 0.4)"}) {
    const auto region = Region("(0 0, 20 0, 20 1, 0 1) " + std::string(hole));
    EXPECT_EQ(MeasuresOf(AxisOf(region)).cycles, 1) << hole;
  }
}

TEST(AxisTracer, RingsMayStartAnywhere) {
  PolygonWithHoles region =
      Region("(0 0, 9 0, 9 3, 5 3, 5.5 8, 1 7, 3 4) (6 1, 8 1, 7 2) (2 6, 4 6, 4 7)");
  const Measures first = MeasuresOf(AxisOf(region));
  ASSERT_GT(first.length, 0);
  for (size_t i = 0; i < region.outer.size(); ++i) {
    std::rotate(region.outer.begin(), region.outer.begin() + 1, region.outer.end());
    for (Polygon& hole : region.holes) std::rotate(hole.begin(), hole.begin() + 1, hole.end());
    const Measures turned = MeasuresOf(AxisOf(region));
    EXPECT_NEAR(turned.length, first.length, 1e-3);
    EXPECT_NEAR(turned.widest, first.widest, 1e-3);
  }
}

void ExpectNoAxis(const PolygonWithHoles& region) {
  const auto boundary = MakeBoundary(region);
  ASSERT_TRUE(boundary.has_value());
  EXPECT_FALSE(MakeSkeletalGraph(*boundary, {}).has_value());
}

TEST(AxisTracer, RingsInTheWrongDirectionAreRefused) {
  for (const char* text : {"(0 0, 4 0, 1 3)", "(0 0, 4 0, 4 3, 2 1, 0 3)",
                           "(0 0, 9 0, 9 9, 0 9) (3 3, 6 3, 6 6, 3 6)"}) {
    SCOPED_TRACE(text);
    PolygonWithHoles clockwise = Region(text);
    std::reverse(clockwise.outer.begin(), clockwise.outer.end());
    ExpectNoAxis(clockwise);
  }
  PolygonWithHoles region = Region("(0 0, 9 0, 9 9, 0 9) (3 3, 6 3, 6 6, 3 6)");
  std::reverse(region.holes[0].begin(), region.holes[0].end());
  ExpectNoAxis(region);
}

// All sides of such a disc have nearly the same distance from its centre. To tell them apart takes
// a test of each against each.
TEST(AxisTracer, ALargeDiscIsLeftToTheVoronoiDiagram) {
  for (const int corners : {500, 501, 505}) {
    const auto boundary = MakeBoundary({Round({0, 0}, 4e7, corners, 0), {}});
    ASSERT_TRUE(boundary.has_value());
    EXPECT_FALSE(TraceAxis(*boundary).has_value()) << corners;
    const auto graph = MakeSkeletalGraph(*boundary, {});
    ASSERT_TRUE(graph.has_value()) << corners;
    EXPECT_NEAR(MeasuresOf(*graph).widest, 4e7, 1e4) << corners;
  }
}

}  // namespace
}  // namespace slicefarm::axis_tracer_test
