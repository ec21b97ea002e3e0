#include "services/exposure/algo/decompose/piece_quality.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::piece_quality_test {
namespace {

TEST(PieceQuality, OfASquareAndATriangle) {
  const Polygon square = MakePolygonsOrDie("(0 0, 1 0, 1 1, 0 1)")[0].outer;
  EXPECT_NEAR(ShapeFactor(square), 4 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(LeastAngleDeg(square), 90, 1e-12);
  EXPECT_NEAR(LeastAngleDeg(MakePolygonsOrDie("(0 0, 1 0, 1 1)")[0].outer), 45, 1e-12);
}

}  // namespace
}  // namespace slicefarm::exposure::piece_quality_test
