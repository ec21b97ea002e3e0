#include "services/infill/algo/patterns/cell_curves.h"

#include <gtest/gtest.h>

#include "services/infill/algo/patterns/pattern_samples_test.h"

namespace slicefarm::infill::cell_curves_test {
namespace {

// Each cell has one pitch of line, and a few pieces contain all cells of a region.
TEST(CellCurves, VisitEveryCellOnce) {
  const double pitch = 2e6;
  for (MakePattern* pattern : {Hilbert, Peano}) {
    const auto pieces = pattern(SampleBox(), {.pitch_nm = pitch});
    EXPECT_NEAR(LengthOf(*pieces) * pitch / Area(SampleBox()), 1, 0.05);
    for (const Piece& piece : *pieces)
      for (size_t i = 1; i < piece.points.size(); ++i)
        EXPECT_TRUE(piece.points[i].x == piece.points[i - 1].x ||
                    piece.points[i].y == piece.points[i - 1].y);
  }
}

// 16 x 16 cells beside the origin are one of the curve's own squares: the curve fills the square
// without a gap.
TEST(CellCurves, HilbertGoesThroughASquareOfItsOwnInOnePiece) {
  const auto square = MakePolygonsOrDie("(0 0, 32 0, 32 32, 0 32)");
  const auto pieces = Hilbert(square, {.pitch_nm = 2e6});
  ASSERT_EQ(pieces->size(), 1u);
  EXPECT_GE(LengthOf(*pieces), 255 * 2e6 - 1);
}

}  // namespace
}  // namespace slicefarm::infill::cell_curves_test
