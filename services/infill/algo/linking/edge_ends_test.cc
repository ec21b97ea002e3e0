#include "services/infill/algo/linking/edge_ends.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "services/infill/algo/lines/straight_pieces.h"

namespace slicefarm::infill::edge_ends_test {
namespace {

const MultiPolygon& Region() {
  static const MultiPolygon region =
      MakePolygonsOrDie("(0 0, 20 0, 20 10, 0 10) (3 3, 3 6, 6 6, 6 3) ; (30 0, 40 3, 31 9)");
  return region;
}

std::vector<Piece> Lines(double angle) {
  const LineFamily families[] = {{angle, 0, 1.1e6}, {angle + 1.5, 0, 1.3e6}};
  return *StraightPieces(Region(), families);
}

// The edge parts of every ring follow each other, and their total length is the ring's length.
TEST(EdgeEnds, StretchesPartTheRings) {
  for (const double angle : {0.0, 0.5, 1.2}) {
    const std::vector<Piece> pieces = Lines(angle);
    const EdgeEnds ends(Region(), pieces);
    ASSERT_EQ(ends.size(), static_cast<int32_t>(2 * pieces.size()));
    ASSERT_EQ(ends.OnEdge().size(), 2 * pieces.size());
    double length = 0, expected = 0;
    ForEachRing(Region(), [&](const Polygon& ring) { expected += Perimeter(ring); });
    for (const int32_t end : ends.OnEdge()) {
      const int32_t next = ends.Next(end);
      EXPECT_EQ(ends.Previous(next), end);
      const Polyline path = ends.SpanPoints(end);
      EXPECT_EQ(path.front(), ends.PositionOf(end));
      EXPECT_EQ(path.back(), ends.PositionOf(next));
      EXPECT_NEAR(Length(path), ends.SpanLength(end), 5);
      length += ends.SpanLength(end);
    }
    EXPECT_NEAR(length, expected, 100);
  }
}

TEST(EdgeEnds, ClosedPiecesAndInnerEndsAreNotOnTheEdge) {
  std::vector<Piece> pieces(2);
  pieces[0] = {MakeLineOrDie("(8 4, 9 4, 9 5)"), {}, {}, true};
  pieces[1] = {MakeLineOrDie("(0 4, 1 4)"), {0, 3}, {}};
  const EdgeEnds ends(Region(), pieces);
  EXPECT_EQ(ends.OnEdge(), std::vector<int32_t>{2});
  EXPECT_EQ(ends.Next(2), 2);
}

TEST(EdgeEnds, AStretchMayGoRoundTheWholeRing) {
  // The two ends are on one edge.
  const std::vector<Piece> pieces = {{MakeLineOrDie("(5 0, 5 2, 7 2, 7 0)"), {0, 0}, {0, 0}}};
  const EdgeEnds ends(Region(), pieces);
  EXPECT_NEAR(ends.SpanLength(0), 2e6, 1);
  EXPECT_NEAR(ends.SpanLength(1), 58e6, 1);
  EXPECT_EQ(ends.SpanPoints(0), MakeLineOrDie("(5 0, 7 0)"));
  EXPECT_EQ(ends.SpanPoints(1), MakeLineOrDie("(7 0, 20 0, 20 10, 0 10, 0 0, 5 0)"));
}

}  // namespace
}  // namespace slicefarm::infill::edge_ends_test
