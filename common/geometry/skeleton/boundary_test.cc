#include "common/geometry/skeleton/boundary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "common/geometry/predicates.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::boundary_test {
namespace {

constexpr Coord kUm = 1'000;

PolygonWithHoles Region(std::string_view text) { return MakePolygonsOrDie(text)[0]; }
std::optional<Boundary> Of(std::string_view text) { return MakeBoundary(Region(text)); }

struct RejectedCase {
  std::string name;
  std::string text;
};
class RejectedOutline : public testing::TestWithParam<RejectedCase> {};

TEST_P(RejectedOutline, HasNoBoundaryOnAnyGrid) {
  const PolygonWithHoles region = Region(GetParam().text);
  EXPECT_FALSE(MakeBoundary(region, kUm).has_value());
  EXPECT_FALSE(MakeBoundary(region, 1).has_value());
  EXPECT_FALSE(MakeBoundary(region).has_value());
}

INSTANTIATE_TEST_SUITE_P(
    Boundary, RejectedOutline,
    testing::Values(
        RejectedCase{"Line", "(0 0, 1 0, 2 0)"},
        RejectedCase{"CrossesItself", "(0 0, 4 4, 4 0, 0 3)"},
        RejectedCase{"CornerTouchesOwnCorner", "(0 0, 2 2, 4 0, 4 4, 2 2, 0 4)"},
        RejectedCase{"CornerTouchesOwnEdge", "(0 0, 4 0, 4 4, 2 0, 0 4)"},
        RejectedCase{"EdgesOverlap", "(0 0, 4 0, 4 2, 2 2, 2 0, 1 0, 1 1, 0 1)"},
        RejectedCase{"HoleCrossesOuter", "(0 0, 4 0, 4 4, 0 4) (3 3, 5 3, 5 5, 3 5)"},
        RejectedCase{"HoleTouchesOuterInAPoint", "(0 0, 4 0, 4 4, 0 4) (0 2, 1 1, 1 3)"},
        RejectedCase{"HoleSharesACorner", "(0 0, 4 0, 4 4, 0 4) (0 0, 2 1, 1 2)"},
        RejectedCase{"HolesTouchInAPoint", "(0 0, 9 0, 9 4, 0 4) (1 1, 4 2, 1 3) (7 1, 7 3, 4 2)"},
        RejectedCase{"HolesCross",
                     "(0 0, 9 0, 9 9, 0 9) (1 1, 5 1, 5 5, 1 5) (4 4, 8 4, 8 8, 4 8)"}),
    [](const auto& info) { return info.param.name; });

TEST(Boundary, EdgesAreLinkedRingByRing) {
  const auto boundary = Of("(0 0, 9 0, 9 9, 4 5, 0 9) (1 1, 3 1, 2 2) (5 1, 8 1, 8 3, 5 3)");
  ASSERT_TRUE(boundary.has_value());
  EXPECT_EQ(boundary->Holes(), 2);
  ASSERT_EQ(boundary->rings.size(), 3u);
  ASSERT_EQ(boundary->edges.size(), 5u + 3u + 4u);
  int first = 0;
  for (const Polygon& ring : boundary->rings) {
    int edge = first;
    for (size_t i = 0; i < ring.size(); ++i) {
      const BoundaryEdge& at = boundary->edges[edge];
      EXPECT_EQ(at.from, ring[i]);
      EXPECT_EQ(boundary->edges[at.next].from, at.to);
      EXPECT_EQ(boundary->edges[at.next].previous, edge);
      edge = at.next;
    }
    EXPECT_EQ(edge, first);
    first += static_cast<int>(ring.size());
  }
}

TEST(Boundary, CollinearPointsAreDropped) {
  const auto boundary = Of("(0 0, 2 0, 5 0, 5 1, 3 1, 0 1, 0 0.5) (1 0.2, 2 0.2, 2 0.5, 2 0.8)");
  ASSERT_TRUE(boundary.has_value());
  EXPECT_EQ(boundary->rings[0].size(), 4u);
  EXPECT_EQ(boundary->rings[1].size(), 3u);
  for (const BoundaryEdge& edge : boundary->edges)
    EXPECT_NE(Orientation(boundary->edges[edge.previous].from, edge.from, edge.to), 0);
}

// The grid decides: a point 0.4 um from the line is on the line in um, but not in nm.
TEST(Boundary, PointsCollinearOnTheGridAreDropped) {
  const PolygonWithHoles region = Region("(0 0, 3 0.0004, 6 0, 6 4, 0 4)");
  EXPECT_EQ(MakeBoundary(region, kUm)->edges.size(), 4u);
  EXPECT_EQ(MakeBoundary(region, 1)->edges.size(), 5u);
}

TEST(Boundary, AHoleWithoutInsideIsNoHole) {
  const auto boundary = Of("(0 0, 4 0, 4 4, 0 4) (1 1, 2 2, 3 3)");
  ASSERT_TRUE(boundary.has_value());
  EXPECT_EQ(boundary->Holes(), 0);
}

TEST(Boundary, TheGridIsOfMicrometresIfThatWillDo) {
  EXPECT_EQ(Of("(0 0, 4 0, 4 4, 0 4) (0.002 2, 1 1, 1 3)")->unit_nm, kUm);
  // After rounding to um, the hole would touch the outer ring.
  const auto fine = Of("(0 0, 4 0, 4 4, 0 4) (0.0004 2, 1 1, 1 3)");
  ASSERT_TRUE(fine.has_value());
  EXPECT_EQ(fine->unit_nm, 1);
  EXPECT_EQ(fine->edges.size(), 7u);
}

TEST(Boundary, CornersAreConvexOrReflexAsSeenFromTheRegion) {
  const auto boundary = Of("(0 0, 9 0, 9 4, 4 4, 4 9, 0 9) (1 1, 3 1, 3 3, 1 3)");
  ASSERT_TRUE(boundary.has_value());
  for (int edge = 0; edge < static_cast<int>(boundary->edges.size()); ++edge) {
    const Point corner = boundary->edges[edge].from + boundary->origin;
    // All corners of the hole (edges 6 to 9) are reflex.
    const bool reflex = edge >= 6 || boundary->edges[edge].from == Point{-500, -500};
    EXPECT_EQ(boundary->StartsReflex(edge), reflex) << ToText(corner);
    EXPECT_EQ(boundary->StartsConvex(edge), !reflex) << ToText(corner);
  }
}

TEST(Boundary, LiesAroundItsOrigin) {
  const PolygonWithHoles region = Region("(100 200, 104 200, 104 208, 100 207.123456)");
  const auto boundary = MakeBoundary(region, 1);
  ASSERT_TRUE(boundary.has_value());
  EXPECT_EQ(boundary->origin, (Point{FromMm(102), FromMm(204)}));
  for (const Point& p : region.outer) {
    const Point local = p - boundary->origin;
    EXPECT_EQ(std::ranges::count(boundary->rings[0], local), 1) << ToText(p);
  }
}

// 3 m exceed the range in nm, but not in um.
TEST(Boundary, IsNoWiderThan32Bits) {
  const PolygonWithHoles wide = Region("(0 0, 3000 0, 3000 1, 0 1)");
  EXPECT_FALSE(MakeBoundary(wide, 1).has_value());
  EXPECT_TRUE(MakeBoundary(wide, kUm).has_value());
  const PolygonWithHoles high = Region("(0 0, 1 0, 1 3000, 0 3000)");
  EXPECT_FALSE(MakeBoundary(high, 1).has_value());
}

}  // namespace
}  // namespace slicefarm::boundary_test
