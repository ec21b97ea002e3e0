#include "services/infill/algo/linking/inner_ends.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::inner_ends_test {
namespace {

constexpr InnerJoints kJoints{.reach_nm = 5e6, .most_added = 0.25};

MultiPolygon Square() { return MakePolygonsOrDie("(0 0, 60 0, 60 60, 0 60)"); }

Piece Line(double x0, double y0, double x1, double y1, bool holds = true) {
  Piece piece{{{FromMm(x0), FromMm(y0)}, {FromMm(x1), FromMm(y1)}}};
  if (holds) piece.from = {0, 3};
  return piece;
}

double LengthOf(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces) {
    length += Length(piece.points);
    if (piece.closed) length += Distance(piece.points.back(), piece.points.front());
  }
  return length;
}

/// Returns lines from the left wall to x = 30, `gap` apart.
std::vector<Piece> Comb(int count, double gap) {
  std::vector<Piece> lines;
  for (int i = 0; i < count; ++i) lines.push_back(Line(0, 10 + gap * i, 30, 10 + gap * i));
  return lines;
}

TEST(InnerEnds, NeighboursAreJoinedInPairsAndKeepTheirLength) {
  const auto joined = JoinInnerEnds(Square(), Comb(6, 3), kJoints);
  ASSERT_EQ(joined.size(), 3u);
  for (const Piece& piece : joined) {
    EXPECT_EQ(piece.points.size(), 4u);
    EXPECT_EQ(piece.from.ring, 0);
    EXPECT_EQ(piece.to.ring, 0);
    EXPECT_EQ(piece.points[1].x, FromMm(28.5));  // cut back by half of the joint
    EXPECT_EQ(piece.points[1].x, piece.points[2].x);
  }
  EXPECT_NEAR(LengthOf(joined), 6 * 30e6, 10);
}

TEST(InnerEnds, AnEndThatIsLeftOverTakesAPartnerThatFindsAnother) {
  // The middle two ends are nearest, but as many ends as possible are joined.
  std::vector<Piece> lines = {Line(0, 10, 30, 10), Line(0, 14, 30, 14), Line(0, 17, 30, 17),
                              Line(0, 21, 30, 21)};
  EXPECT_EQ(JoinInnerEnds(Square(), lines, kJoints).size(), 2u);
}

TEST(InnerEnds, LinesGoOn) {
  const std::vector<Piece> halves = {Line(0, 20, 30, 20), Line(60, 20, 30, 20)};
  const auto joined = JoinInnerEnds(Square(), halves, kJoints);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_NEAR(LengthOf(joined), 60e6, 2);
}

TEST(InnerEnds, LinesThatFaceEachOtherAddALittle) {
  const std::vector<Piece> halves = {Line(0, 20, 30, 20), Line(60, 22, 30, 22)};
  const auto joined = JoinInnerEnds(Square(), halves, kJoints);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_GT(LengthOf(joined), 60e6);
  EXPECT_LE(LengthOf(joined), 60e6 + 0.25 * 2e6);
}

TEST(InnerEnds, WhatIsTooFarOrOnTheEdgeStays) {
  EXPECT_EQ(JoinInnerEnds(Square(), Comb(4, 6), kJoints).size(), 4u);
  std::vector<Piece> across = Comb(4, 3);
  for (Piece& piece : across) piece.to = {0, 1};
  EXPECT_EQ(JoinInnerEnds(Square(), across, kJoints).size(), 4u);
  EXPECT_TRUE(JoinInnerEnds(Square(), {}, kJoints).empty());
}

TEST(InnerEnds, JointsCrossNoEdgeAndLieOnNoLine) {
  const auto slit = MakePolygonsOrDie("(0 0, 60 0, 60 60, 0 60) (5 11, 5 12, 40 12, 40 11)");
  EXPECT_EQ(JoinInnerEnds(slit, Comb(2, 3), kJoints).size(), 2u);
  std::vector<Piece> beside = Comb(2, 3);
  beside.push_back(Line(28.4, 0, 28.4, 60));
  beside.back().to = {0, 2};
  EXPECT_EQ(JoinInnerEnds(Square(), beside, kJoints).size(), 3u);
}

// Two joints would overlap each other: one is made, and the two ends of the other joint stay loose.
TEST(InnerEnds, JointsLieOnNoJoint) {
  std::vector<Piece> lines = {Line(0, 20, 30, 20), Line(0, 23, 30, 23), Line(60, 20.1, 26.9, 20.1),
                              Line(60, 23.1, 26.9, 23.1)};
  for (size_t i : {2, 3}) lines[i].from = {0, 1};
  const InnerJoints wide{.reach_nm = 3.05e6, .most_added = 0.1};
  EXPECT_EQ(JoinInnerEnds(Square(), lines, wide).size(), 3u);
}

TEST(InnerEnds, PiecesWithTwoInnerEndsMayBecomeARing) {
  const std::vector<Piece> lines = {Line(10, 20, 40, 20, false), Line(10, 23, 40, 23, false)};
  const auto joined = JoinInnerEnds(Square(), lines, kJoints);
  ASSERT_EQ(joined.size(), 1u);
  EXPECT_TRUE(joined[0].closed);
  EXPECT_NEAR(LengthOf(joined), 60e6, 10);
}

// A joint between the ends of a straight line would print it twice. A bow is joined to itself.
TEST(InnerEnds, APieceIsJoinedToItselfOnlyBesideItself) {
  const std::vector<Piece> straight = {Line(20, 20, 24, 20, false)};
  const auto alone = JoinInnerEnds(Square(), straight, kJoints);
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_FALSE(alone[0].closed);
  EXPECT_EQ(alone[0].points, straight[0].points);
  Piece bow = Line(20, 20, 30, 20, false);
  bow.points.push_back({FromMm(30), FromMm(23)});
  bow.points.push_back({FromMm(20), FromMm(23)});
  const auto ring = JoinInnerEnds(Square(), std::vector<Piece>{bow}, kJoints);
  ASSERT_EQ(ring.size(), 1u);
  EXPECT_TRUE(ring[0].closed);
}

TEST(InnerEnds, TheOrderAndWayOfPiecesChangesNothing) {
  std::vector<Piece> lines = Comb(9, 2.3);
  const double all = LengthOf(JoinInnerEnds(Square(), lines, kJoints));
  for (size_t i = 0; i < lines.size(); i += 2) {
    std::ranges::reverse(lines[i].points);
    std::swap(lines[i].from, lines[i].to);
  }
  std::ranges::reverse(lines);
  const auto again = JoinInnerEnds(Square(), lines, kJoints);
  EXPECT_EQ(again.size(), 5u);
  EXPECT_NEAR(LengthOf(again), all, 20);
}

}  // namespace
}  // namespace slicefarm::infill::inner_ends_test
