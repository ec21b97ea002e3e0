#include "services/infill/algo/patterns/rectilinear.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format.h"

namespace slicefarm::infill {
namespace {

MultiPolygon Box() { return MakePolygonsOrDie("(-24 -24, 24 -24, 24 24, -24 24)"); }

double LengthOf(const std::vector<Piece>& pieces) {
  double length = 0;
  for (const Piece& piece : pieces)
    length += piece.closed ? Perimeter(piece.points) : Length(piece.points);
  return length;
}

TEST(Rectilinear, TurnsFromLayerToLayerUnlessAligned) {
  for (const int32_t layer : {0, 1}) {
    const PatternPlace place{.layer = layer, .pitch_nm = 2e6};
    const auto turning = Rectilinear(Box(), place), aligned = AlignedRectilinear(Box(), place);
    EXPECT_EQ((*aligned)[0].points[0].y, (*aligned)[0].points[1].y);
    EXPECT_EQ((*turning)[0].points[0].y == (*turning)[0].points[1].y, layer == 0);
    EXPECT_NEAR(LengthOf(*turning), 48e6 * 24, 1);
  }
}

}  // namespace
}  // namespace slicefarm::infill
