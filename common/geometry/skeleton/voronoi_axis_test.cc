#include "common/geometry/skeleton/voronoi_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "common/geometry/text_format_test.h"

namespace slicefarm::voronoi_axis_test {
namespace {

Boundary BoundaryOf(std::string_view text) {
  const auto boundary = MakeBoundary(MakePolygonsOrDie(text)[0]);
  EXPECT_TRUE(boundary.has_value());
  return boundary.value_or(Boundary{});
}

double LengthOf(const SkeletalGraph& axis) {
  double length = 0;
  for (int half = 0; half < static_cast<int>(axis.half_edges.size()); half += 2)
    length += axis.Length(half);
  return length;
}

TEST(VoronoiAxis, OfASquareIsItsDiagonals) {
  for (const auto make : {VoronoiAxis, ExactVoronoiAxis}) {
    const auto axis = make(BoundaryOf("(0 0, 2 0, 2 2, 0 2)"));
    ASSERT_TRUE(axis.has_value());
    EXPECT_NEAR(LengthOf(*axis), 4'000'000 * std::sqrt(2), 1);
  }
}

// Nearly parallel sides: with coarser decisions, discs along the strip are only roughly compared.
TEST(VoronoiAxis, LooseDecisionsGiveTheExactAxis) {
  for (const std::string_view text :
       {"(0 0, 10 -0.05, 10 0.05)", "(0 0, 40 0.001, 40 0.4, 0 0.402)",
        "(0 0, 9 0, 9 3, 5 3, 5.5 8, 1 7, 3 4) (6 1, 8 1, 7 2) (2 6, 4 6, 4 7)"}) {
    const Boundary boundary = BoundaryOf(text);
    const auto loose = VoronoiAxis(boundary), exact = ExactVoronoiAxis(boundary);
    ASSERT_TRUE(loose.has_value() && exact.has_value()) << text;
    EXPECT_EQ(loose->half_edges.size(), exact->half_edges.size()) << text;
    EXPECT_NEAR(LengthOf(*loose), LengthOf(*exact), 1) << text;
  }
}

TEST(VoronoiAxis, WalksAroundEachRing) {
  const Boundary boundary = BoundaryOf("(0 0, 9 0, 9 9, 0 9) (3 3, 6 3, 6 6, 3 6)");
  const auto axis = VoronoiAxis(boundary);
  ASSERT_TRUE(axis.has_value());
  int changes = 0;
  for (int half = 0; half < static_cast<int>(axis->half_edges.size()); ++half) {
    const HalfEdge& edge = axis->half_edges[half];
    ASSERT_EQ(axis->half_edges[edge.next].from, axis->To(half));
    changes += edge.feature != axis->half_edges[edge.next].feature ||
               edge.is_corner != axis->half_edges[edge.next].is_corner;
  }
  // Eight edges, and four reflex corners of the hole.
  EXPECT_EQ(changes, 12);
}

}  // namespace
}  // namespace slicefarm::voronoi_axis_test
