#include "services/beading/algo/arachne/bead_tracing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/beading/algo/arachne/beading_field.h"
#include "services/beading/algo/skeleton/centrality.h"
#include "services/beading/algo/strategy/strategy_factory.h"

namespace slicefarm::beading::bead_tracing_test {
namespace {

constexpr Coord kTransitionNm = 400'000;

PolygonWithHoles Region(std::string_view text) { return MakePolygonsOrDie(text)[0]; }

/// Returns the beads of a region, in nm relative to the region's own origin.
std::vector<BeadLine> BeadsOf(const PolygonWithHoles& region, int max_walls = 0) {
  StrategyOptions options;
  options.max_walls = max_walls;
  options.transition_length_nm = kTransitionNm;
  const auto strategy = MakeStrategy(options);
  SkeletalGraph graph = *MakeSkeletalGraph(*MakeBoundary(region), {.step_nm = 200'000});
  std::vector<char> central = CentralEdges(graph, {});
  std::vector<BeadCount> counts = PlanBeadCounts(*strategy, {}, graph, central);
  const auto field = BeadingField(*strategy, kTransitionNm, graph, counts, central);
  EXPECT_EQ(field.size(), graph.nodes.size());
  EXPECT_EQ(counts.size(), graph.nodes.size());
  std::vector<BeadLine> lines = TraceBeads(graph, central, field, {});
  for (BeadLine& line : lines) {
    for (BeadPoint& point : line.points) {
      point.place.x() += static_cast<double>(graph.origin.x);
      point.place.y() += static_cast<double>(graph.origin.y);
    }
  }
  return lines;
}

std::vector<BeadLine> Middles(const std::vector<BeadLine>& lines) {
  std::vector<BeadLine> middles;
  std::ranges::copy_if(lines, std::back_inserter(middles), &BeadLine::is_middle);
  return middles;
}

double DistanceToBoundary(Vector2 place, const PolygonWithHoles& region) {
  const Point p = {std::llround(place.x()), std::llround(place.y())};
  double distance = std::numeric_limits<double>::infinity();
  for (const Polygon& ring : Rings({region}))
    for (size_t i = 0; i < ring.size(); ++i)
      distance = std::min(distance, DistanceToSegment(p, ring[i], ring[(i + 1) % ring.size()]));
  return distance;
}

double LengthMm(const BeadLine& line) {
  double length = 0;
  for (size_t i = line.closed ? 0 : 1; i < line.points.size(); ++i) {
    const Vector2 a = line.points[i == 0 ? line.points.size() - 1 : i - 1].place;
    const Vector2 b = line.points[i].place;
    length += std::hypot(b.x() - a.x(), b.y() - a.y()) / kNmPerMm;
  }
  return length;
}

PolygonWithHoles RegularPolygon(int corners, double inner_radius_mm) {
  const double radius = inner_radius_mm / std::cos(std::numbers::pi / corners);
  PolygonWithHoles polygon;
  for (int i = 0; i < corners; ++i) {
    const double turn = 2 * std::numbers::pi * (i + 0.3) / corners;
    polygon.outer.push_back({FromMm(radius * std::cos(turn)), FromMm(radius * std::sin(turn))});
  }
  return polygon;
}

// Tests of strips.

struct StripCase {
  int beads;
  std::string thickness_mm;
};
class StripBeads : public testing::TestWithParam<StripCase> {};

TEST_P(StripBeads, AreClosedOnTheSidesAndOpenInTheMiddle) {
  const auto& [beads, y] = GetParam();
  const PolygonWithHoles region = Region("(0 0, 20 0, 20 " + y + ", 0 " + y + ")");
  const auto lines = BeadsOf(region);
  const int sides = beads / 2;
  ASSERT_EQ(lines.size(), static_cast<size_t>(sides + beads % 2));
  for (int inset = 0; inset < static_cast<int>(lines.size()); ++inset) {
    const BeadLine& line = lines[inset];
    EXPECT_EQ(line.inset, inset);
    EXPECT_EQ(line.is_middle, inset == sides);
    EXPECT_EQ(line.closed, inset < sides);
    EXPECT_FALSE(line.is_marker);
    // Beads lie side by side, regardless of their widths.
    double location = DistanceToBoundary(line.points[0].place, region);
    if (beads == 1) {
      // The ends of a single bead extend into the ends of the strip.
      location = line.points[0].width / 2;
      for (const BeadPoint& end : {line.points.front(), line.points.back()})
        EXPECT_NEAR(DistanceToBoundary(end.place, region), (1 - 2 * 0.107) * location, 2);
    }
    for (const BeadPoint& point : line.points) {
      if (beads > 1) {
        EXPECT_NEAR(DistanceToBoundary(point.place, region), location, 2);
      }
      EXPECT_NEAR(point.width, line.points[0].width, 2);
    }
    if (inset > 0) {
      const BeadLine& before = lines[inset - 1];
      const double last = DistanceToBoundary(before.points[0].place, region);
      EXPECT_NEAR(location - last, (line.points[0].width + before.points[0].width) / 2, 2);
    } else {
      EXPECT_NEAR(location, line.points[0].width / 2, 2);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(BeadTracing, StripBeads,
                         testing::Values(StripCase{1, "0.35"}, StripCase{1, "0.6"},
                                         StripCase{2, "0.8"}, StripCase{2, "1"},
                                         StripCase{3, "1.3"}, StripCase{4, "1.6"},
                                         StripCase{5, "2.1"}, StripCase{10, "4"}),
                         [](const auto& info) {
                           std::string name = std::to_string(info.param.beads) + "In";
                           for (const char c : info.param.thickness_mm) name += c == '.' ? '_' : c;
                           return name;
                         });

TEST(BeadTracing, NothingIsTracedWhereNoBeadFits) {
  EXPECT_TRUE(BeadsOf(Region("(0 0, 20 0, 20 0.08, 0 0.08)")).empty());
}

TEST(BeadTracing, MarkersAreClosedAndWithinTheWalls) {
  const PolygonWithHoles region = Region("(0 0, 9 0, 9 6, 4 6, 4 9, 0 9)");
  const auto lines = BeadsOf(region, 2);
  int markers = 0;
  for (const BeadLine& line : lines) {
    EXPECT_TRUE(line.closed);
    EXPECT_EQ(line.is_marker, line.inset == 2);
    markers += line.is_marker;
    for (const BeadPoint& point : line.points) {
      EXPECT_EQ(point.width, line.is_marker ? 0 : 400'000);
      const double location = DistanceToBoundary(point.place, region);
      EXPECT_NEAR(location, line.is_marker ? 800'000 : 200'000 + 400'000 * line.inset, 5'000);
    }
  }
  EXPECT_EQ(markers, 1);
  EXPECT_EQ(lines.size(), 3u);
}

TEST(BeadTracing, WithAHoleThereIsALineAroundEachRing) {
  const auto lines = BeadsOf(Region("(0 0, 20 0, 20 20, 0 20) (8 8, 12 8, 12 12, 8 12)"), 2);
  ASSERT_EQ(lines.size(), 6u);
  for (const BeadLine& line : lines) EXPECT_TRUE(line.closed);
}

// Tests of transitions between numbers of beads.

TEST(BeadTracing, AMiddleBeadRetreatsBeforeItsTwoHalves) {
  const auto lines =
      BeadsOf(Region("(0 0, 4 0, 9 -0.35, 13 -0.35, 13 0.65, 9 0.65, 4 0.3, 0 0.3)"));
  ASSERT_EQ(lines.size(), 2u);
  const BeadLine &halves = lines[0], &middle = lines[1];
  EXPECT_TRUE(halves.closed);
  EXPECT_TRUE(middle.is_middle);
  EXPECT_FALSE(middle.closed);
  const auto by_x = [](const BeadPoint& a, const BeadPoint& b) {
    return a.place.x() < b.place.x();
  };
  const BeadPoint first = *std::ranges::min_element(halves.points, by_x);
  const BeadPoint last = *std::ranges::max_element(middle.points, by_x);
  EXPECT_NEAR(first.width, last.width / 2, 0.05 * last.width);
  const double gap = (first.place.x() - last.place.x()) / last.width;
  EXPECT_GT(gap, 0.5);
  EXPECT_LT(gap, 0.75);
  // At the other end, the bead extends into the corners of the flat end.
  EXPECT_NEAR(std::ranges::min_element(middle.points, by_x)->place.x(), 150'000 - 0.107 * 340'000,
              1'000);
}

TEST(BeadTracing, AMiddleBeadThatGrowsBeginsAtTheLeastWidth) {
  // The number changes from two beads to three.
  const auto lines =
      BeadsOf(Region("(0 0, 4 0, 9 -0.25, 13 -0.25, 13 1.15, 9 1.15, 4 0.9, 0 0.9)"));
  const auto middles = Middles(lines);
  ASSERT_EQ(middles.size(), 1u);
  EXPECT_EQ(middles[0].inset, 1);
  double least = 1e9;
  for (const BeadPoint& point : middles[0].points) least = std::min(least, point.width);
  EXPECT_NEAR(least, TracingOptions{}.min_middle_width_nm, 1);
}

// Tests of tops and rings.

struct DotCase {
  int corners;
  double inner_radius_mm;
  int sides;
  double width_mm;
};
class RegularDot : public testing::TestWithParam<DotCase> {};

TEST_P(RegularDot, CoversTheTop) {
  const DotCase& dot = GetParam();
  const auto lines = BeadsOf(RegularPolygon(dot.corners, dot.inner_radius_mm));
  ASSERT_EQ(lines.size(), static_cast<size_t>(dot.sides + 1));
  for (int inset = 0; inset < dot.sides; ++inset) EXPECT_TRUE(lines[inset].closed);
  const BeadLine& middle = lines.back();
  EXPECT_TRUE(middle.is_middle);
  EXPECT_FALSE(middle.closed);
  EXPECT_EQ(middle.inset, dot.sides);
  EXPECT_NEAR(LengthMm(middle), 0.2 * dot.width_mm, 0.02 * dot.width_mm);
  for (const BeadPoint& point : middle.points) {
    EXPECT_NEAR(point.width, dot.width_mm * kNmPerMm, 5'000);
    EXPECT_LT(std::hypot(point.place.x(), point.place.y()), 0.15 * point.width);
  }
}

INSTANTIATE_TEST_SUITE_P(BeadTracing, RegularDot,
                         testing::Values(DotCase{3, 0.25, 0, 0.5}, DotCase{4, 0.25, 0, 0.5},
                                         DotCase{4, 0.6, 1, 0.4}, DotCase{5, 0.6, 1, 0.4},
                                         DotCase{6, 0.6, 1, 0.4}),
                         [](const auto& info) {
                           return "Corners" + std::to_string(info.param.corners) + "Sides" +
                                  std::to_string(info.param.sides);
                         });

// The top is a very short line along the axis here, which must cover no less than a dot.
TEST(BeadTracing, AShortTopIsCoveredAsADotIs) {
  for (const std::string_view longer : {"1.2", "1.201", "1.21", "1.25"}) {
    const std::string x(longer);
    const auto middles = Middles(BeadsOf(Region("(0 0, " + x + " 0, " + x + " 1.2, 0 1.2)")));
    ASSERT_EQ(middles.size(), 1u) << longer;
    EXPECT_GT(LengthMm(middles[0]), 0.19 * 0.4) << longer;
  }
}

TEST(BeadTracing, ATopOfEvenCountHasNoDot) {
  // The second region is thick enough for five beads; see CountAtTop.
  for (const PolygonWithHoles& region : {RegularPolygon(6, 0.8), RegularPolygon(12, 1)}) {
    const auto lines = BeadsOf(region);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_TRUE(Middles(lines).empty());
  }
}

PolygonWithHoles Ring(int corners, double outer_mm, double inner_mm) {
  PolygonWithHoles ring = RegularPolygon(corners, outer_mm);
  ring.holes = {RegularPolygon(corners, inner_mm).outer};
  std::reverse(ring.holes[0].begin(), ring.holes[0].end());
  return ring;
}

TEST(BeadTracing, TheMiddleOfARingIsClosed) {
  const auto thin = BeadsOf(Ring(64, 5, 4.6));
  ASSERT_EQ(thin.size(), 1u);
  EXPECT_TRUE(thin[0].is_middle);
  EXPECT_TRUE(thin[0].closed);
  EXPECT_EQ(thin[0].inset, 0);
  EXPECT_NEAR(LengthMm(thin[0]), 2 * std::numbers::pi * 4.8, 0.05);

  const auto thick = BeadsOf(Ring(64, 5, 3.8));
  ASSERT_EQ(thick.size(), 3u);
  for (const BeadLine& line : thick) EXPECT_TRUE(line.closed);
  EXPECT_EQ(Middles(thick).size(), 1u);
  EXPECT_EQ(Middles(thick)[0].inset, 1);
}

// Near the corner the axis is steeper than central, but the numbers of beads on both sides are
// equal.
TEST(BeadTracing, ALoneBeadGoesOnAroundACorner) {
  const auto bent = BeadsOf(Region("(0 0, 9 0, 9 0.4, 0.4 0.4, 0.4 5, 0 5)"));
  ASSERT_EQ(bent.size(), 1u);
  EXPECT_FALSE(bent[0].closed);
  EXPECT_GT(LengthMm(bent[0]), 13);
}

TEST(BeadTracing, TheMiddleOfASquareFrameIsClosed) {
  const auto frame = BeadsOf(Region("(0 0, 9 0, 9 9, 0 9) (0.4 0.4, 8.6 0.4, 8.6 8.6, 0.4 8.6)"));
  ASSERT_EQ(frame.size(), 1u);
  EXPECT_TRUE(frame[0].is_middle);
  EXPECT_TRUE(frame[0].closed);
  EXPECT_NEAR(LengthMm(frame[0]), 4 * 8.6, 0.3);
}

}  // namespace
}  // namespace slicefarm::beading::bead_tracing_test
