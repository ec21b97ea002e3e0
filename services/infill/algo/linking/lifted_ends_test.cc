#include "services/infill/algo/linking/lifted_ends.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::lifted_ends_test {
namespace {

constexpr Coord kWidth = 450'000;

MultiPolygon Box() { return MakePolygonsOrDie("(0 0, 20 0, 20 10, 0 10)"); }

Piece Make(std::string_view line, EdgePosition from, EdgePosition to) {
  return {MakeLineOrDie(line), from, to};
}

TEST(LiftEnds, ASteepEndStays) {
  const std::vector<Piece> pieces = {Make("(5 0, 9 10)", {0, 0}, {0, 2})};
  const LiftedPieces lifted = LiftEnds(Box(), pieces, kWidth);
  EXPECT_EQ(lifted.pieces[0].points, pieces[0].points);
  EXPECT_TRUE(lifted.taken[0].empty());
}

// The line rises by 1 in 10: it is 0.62 widths away from the edge after 2.79 mm.
TEST(LiftEnds, AFlatEndGoesStraightToTheEdge) {
  const std::vector<Piece> pieces = {Make("(2 0, 20 1.8)", {0, 0}, {0, 1})};
  const LiftedPieces lifted = LiftEnds(Box(), pieces, kWidth);
  const Polyline& points = lifted.pieces[0].points;
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].y, 0);
  EXPECT_NEAR(static_cast<double>(points[0].x), 4.79e6, 20'000);
  EXPECT_NEAR(DistanceToSegment(points[1], {0, 0}, {20'000'000, 0}), 0.62 * kWidth, 5'000);
  EXPECT_EQ(points[2], (Point{20'000'000, 1'800'000}));
  EXPECT_EQ(lifted.pieces[0].from.edge, 0);
  EXPECT_TRUE(lifted.taken[0].empty()) << "the edge is free for a link";
}

TEST(LiftEnds, ALineBesideTheEdgeTakesIt) {
  const std::vector<Piece> pieces = {Make("(0 0.2, 20 0.2)", {0, 3}, {0, 1})};
  const LiftedPieces lifted = LiftEnds(Box(), pieces, kWidth);
  EXPECT_EQ(lifted.pieces[0].points, pieces[0].points);
  ASSERT_EQ(lifted.taken[0].size(), 1u);
  EXPECT_NEAR(lifted.taken[0][0].from_nm, 0, 1);
  EXPECT_NEAR(lifted.taken[0][0].to_nm, 20e6, 1);
}

TEST(LiftEnds, ClosedPiecesAndInnerEndsStay) {
  std::vector<Piece> pieces = {Make("(2 0.1, 9 0.1)", {}, {}), Make("(12 2, 14 2, 14 4)", {}, {})};
  pieces[1].closed = true;
  const LiftedPieces lifted = LiftEnds(Box(), pieces, kWidth);
  for (size_t i = 0; i < pieces.size(); ++i) EXPECT_EQ(lifted.pieces[i].points, pieces[i].points);
  EXPECT_EQ(lifted.taken[0].size(), 1u);
}

}  // namespace
}  // namespace slicefarm::infill::lifted_ends_test
