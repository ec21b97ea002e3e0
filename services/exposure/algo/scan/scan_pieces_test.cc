#include "services/exposure/algo/scan/scan_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::scan_pieces_test {
namespace {

double AreaMm2(const ConvexPieces& pieces) {
  double nm2 = 0;
  for (const Polygon& piece : pieces.pieces) nm2 += SignedArea(piece);
  return nm2 / static_cast<double>(pieces.scale) / static_cast<double>(pieces.scale) * 1e-12;
}

// An offset cannot create such rings, but rounding and simplification can: they are repaired and
// not rejected.
TEST(ScanPieces, CutsRingsThatCross) {
  const char* const kCases[] = {
      "(0 0, 10 0, 10 10, 5 -0.0005, 0 10)",  // a corner that reaches through an edge
      "(0 0, 10 0, 10 5, 9 5, 9 4.9995, 10 4.9995, 10 10, 0 10)"};
  for (const char* text : kCases) {
    const MultiPolygon crossed = MakePolygonsOrDie(text);
    const auto pieces = ScanPieces(crossed, DecomposeMethod::kBian, 0, {});
    ASSERT_TRUE(pieces.ok()) << text << pieces.status();
    EXPECT_NEAR(AreaMm2(*pieces), Area(Union(crossed, {})) * 1e-12, 0.05) << text;
  }
}

TEST(ScanPieces, LeavesWhatIsSoundAsItIs) {
  const MultiPolygon block = MakePolygonsOrDie("(0 0, 10 0, 10 10, 5 10, 5 5, 0 5)");
  const auto pieces = ScanPieces(block, DecomposeMethod::kBian, 0, {});
  ASSERT_TRUE(pieces.ok()) << pieces.status();
  EXPECT_EQ(pieces->pieces.size(), 2u);
  EXPECT_DOUBLE_EQ(AreaMm2(*pieces), 75);
}

TEST(ScanPieces, IsCancelled) {
  const CancelToken cancel([] { return true; });
  const auto pieces = ScanPieces(MakePolygonsOrDie("(0 0, 10 0, 10 10, 5 10, 5 5, 0 5)"),
                                 DecomposeMethod::kBian, 0, cancel);
  EXPECT_TRUE(absl::IsCancelled(pieces.status()));
}

}  // namespace
}  // namespace slicefarm::exposure::scan_pieces_test
