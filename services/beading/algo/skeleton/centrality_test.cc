#include "services/beading/algo/skeleton/centrality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>

#include "common/geometry/text_format_test.h"

namespace slicefarm::beading::centrality_test {
namespace {

struct Central {
  double length_mm = 0;
  int edges = 0;
  /// X range from the left end of the leftmost edge to the right end of the rightmost edge.
  double from_x_mm = 1e9, to_x_mm = -1e9;
};

Central Of(std::string_view text, double degrees, double min_length_mm = 0.02) {
  const double angle = degrees / 180 * std::numbers::pi;
  const auto boundary = MakeBoundary(MakePolygonsOrDie(text)[0]);
  const auto graph = MakeSkeletalGraph(*boundary, {.transition_angle = angle});
  const std::vector<char> central =
      CentralEdges(*graph, {.transition_angle = angle, .min_length_nm = min_length_mm * kNmPerMm});
  EXPECT_EQ(central.size(), graph->half_edges.size() / 2);
  Central found;
  for (size_t edge = 0; edge < central.size(); ++edge) {
    if (!central[edge]) continue;
    const int half = static_cast<int>(2 * edge);
    ++found.edges;
    found.length_mm += graph->Length(half) / kNmPerMm;
    for (const SkeletalNode& node : {graph->FromNode(half), graph->ToNode(half)}) {
      const double x = (node.place.x() + static_cast<double>(graph->origin.x)) / kNmPerMm;
      found.from_x_mm = std::min(found.from_x_mm, x);
      found.to_x_mm = std::max(found.to_x_mm, x);
    }
  }
  return found;
}

TEST(Centrality, OfAStripIsItsMiddle) {
  const Central central = Of("(0 0, 10 0, 10 0.4, 0 0.4)", 10);
  EXPECT_EQ(central.edges, 1);
  EXPECT_NEAR(central.from_x_mm, 0.2, 1e-4);
  EXPECT_NEAR(central.to_x_mm, 9.8, 1e-4);
}

TEST(Centrality, PlacesThinnerThanTheLeastAreNotCentral) {
  EXPECT_EQ(Of("(0 0, 10 0, 10 0.09, 0 0.09)", 10).edges, 0);
  EXPECT_EQ(Of("(0 0, 10 0, 10 0.11, 0 0.11)", 10).edges, 1);
}

struct AngleCase {
  std::string name;
  std::string text;
  double degrees;  ///< angle between the sides
  double length_mm;
};
class MeetingSides : public testing::TestWithParam<AngleCase> {};

TEST_P(MeetingSides, AreCentralBelowTheTransitionAngle) {
  const AngleCase& sides = GetParam();
  EXPECT_EQ(Of(sides.text, 10).edges, 0);
  EXPECT_EQ(Of(sides.text, sides.degrees - 1).edges, 0);
  EXPECT_NEAR(Of(sides.text, sides.degrees + 1).length_mm, sides.length_mm, 0.001);
}

// An angle of 45 degrees makes the wedge central, but not the two corners at its wide end.
INSTANTIATE_TEST_SUITE_P(
    Centrality, MeetingSides,
    testing::Values(AngleCase{"Square", "(0 0, 2 0, 2 2, 0 2)", 90, 4 * std::numbers::sqrt2},
                    AngleCase{"WedgeOf30Degrees", "(0 0, 10 -2.6795, 10 2.6795)", 30, 7.944}),
    [](const auto& info) { return info.param.name; });

TEST(Centrality, AWedgeOf30DegreesIsCentralAt45) {
  const Central central = Of("(0 0, 10 -2.6795, 10 2.6795)", 45);
  EXPECT_NEAR(central.from_x_mm, 0, 1e-4);
  EXPECT_NEAR(central.to_x_mm, 7.944, 0.001);
}

// The stem is at the middle of the bar, with a slope of 0.6, and is 0.45 mm long from there.
TEST(Centrality, ShortEndsAreTrimmed) {
  constexpr std::string_view kTee =
      "(0 0, 10 0, 10 0.4, 5.2 0.4, 5.2 0.9, 4.8 0.9, 4.8 0.4, 0 0.4)";
  const Central whole = Of(kTee, 80, 0.44), trimmed = Of(kTee, 80, 0.46);
  EXPECT_NEAR(whole.length_mm - trimmed.length_mm, 0.45, 0.001);
  EXPECT_NEAR(trimmed.from_x_mm, 0.2, 1e-4);
  EXPECT_NEAR(trimmed.to_x_mm, 9.8, 1e-4);
}

TEST(Centrality, ALoneShortLineIsKept) {
  EXPECT_NEAR(Of("(0 0, 1 0, 1 0.4, 0 0.4)", 10, 5).length_mm, 0.6, 0.001);
  // With three short ends, a line of two of them remains.
  EXPECT_GT(Of("(0 0, 2 0, 2 0.4, 1.2 0.4, 1.2 0.9, 0.8 0.9, 0.8 0.4, 0 0.4)", 80, 5).length_mm,
            0.8);
}

}  // namespace
}  // namespace slicefarm::beading::centrality_test
