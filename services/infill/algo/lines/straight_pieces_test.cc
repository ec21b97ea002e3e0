#include "services/infill/algo/lines/straight_pieces.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::infill::straight_pieces_test {
namespace {

TEST(StraightPieces, EndOnTheEdgesThatTheyName) {
  const MultiPolygon region =
      MakePolygonsOrDie("(0 0, 20 0, 20 10, 0 10) (3 3, 3 6, 6 6, 6 3) ; (30 0, 40 3, 31 9)");
  const std::vector<Polygon> rings = Rings(region);
  const LineFamily families[] = {{0.3, 1e5, 1.1e6}, {0.3 + std::numbers::pi / 2, 0, 1.7e6}};
  const auto pieces = StraightPieces(region, families);
  ASSERT_TRUE(pieces.ok());
  double expected = 0, length = 0;
  for (const LineFamily& family : families) expected += CutLines(region, family)->TotalLength();
  for (const Piece& piece : *pieces) {
    ASSERT_EQ(piece.points.size(), 2u);
    length += Distance(piece.points[0], piece.points[1]);
    for (const auto& [place, point] :
         {std::pair{piece.from, piece.points[0]}, std::pair{piece.to, piece.points[1]}}) {
      const Polygon& ring = rings[static_cast<size_t>(place.ring)];
      const auto edge = static_cast<size_t>(place.edge);
      EXPECT_LE(DistanceToSegment(point, ring[edge], ring[(edge + 1) % ring.size()]), 1.5);
    }
  }
  EXPECT_NEAR(length, expected, 100);
}

TEST(StraightPieces, NothingOfNothing) {
  const LineFamily family{0, 0, 1e6};
  EXPECT_TRUE(StraightPieces({}, {&family, 1})->empty());
  EXPECT_TRUE(StraightPieces(MakePolygonsOrDie("(0 0, 9 0, 9 9)"), {})->empty());
}

}  // namespace
}  // namespace slicefarm::infill::straight_pieces_test
