#include "services/planning/algo/supports/generator/slender.h"

#include <gtest/gtest.h>

#include <string>

#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::slender_test {
namespace {

constexpr Coord kPixelNm = 250'000;
const PixelGrid kGrid = GridOver({{FromMm(-5), FromMm(-5)}, {FromMm(25), FromMm(25)}}, kPixelNm);

Bitmap Of(const MultiPolygon& region) {
  Bitmap bitmap(kGrid);
  bitmap.Fill(region);
  return bitmap;
}

double Mm2(const Bitmap& bitmap) {
  double pixels = 0;
  for (size_t i = 0; i < kGrid.size(); ++i) pixels += bitmap.Row(0)[i];
  return pixels * 0.0625;
}

MultiPolygon Frame() { return Difference(BoxOf(0, 0, 20, 20), BoxOf(1, 1, 19, 19)); }

struct Case {
  std::string name;
  MultiPolygon piece;
  double widened_mm;  ///< width added on each side; 0: unchanged
};

class AroundSlenderTest : public testing::TestWithParam<Case> {};

TEST_P(AroundSlenderTest, MakesRoomForADisc) {
  const auto& [name, piece, widened_mm] = GetParam();
  const Bitmap bitmap = Of(piece);
  const Bitmap around = AroundSlender(bitmap, bitmap, 900'000);
  if (widened_mm == 0) {
    EXPECT_EQ(Mm2(around), 0);
    return;
  }
  Bitmap both = around;
  for (size_t i = 0; i < kGrid.size(); ++i) {
    EXPECT_FALSE(around.Row(0)[i] && bitmap.Row(0)[i]);
    both.Row(0)[i] |= bitmap.Row(0)[i];
  }
  EXPECT_GT(Mm2(around), 0);
  EXPECT_EQ(Mm2(AroundSlender(both, both, 900'000 - kPixelNm)), 0) << "wide enough now";
  const Box box = Bounds(piece);
  for (int32_t y = 0; y < kGrid.height; ++y)
    for (int32_t x = 0; x < kGrid.width; ++x)
      if (around.At(x, y)) {
        const Point centre = kGrid.Centre(x, y);
        EXPECT_TRUE(box.Grown(FromMm(widened_mm)).Intersects({centre, centre}));
      }
}

INSTANTIATE_TEST_SUITE_P(
    Pieces, AroundSlenderTest,
    testing::Values(Case{"Wall", BoxOf(0, 5, 20, 6), 0.8},
                    Case{"WallOfAPixel", BoxOf(0, 5, 20, 5.25), 1.1},
                    Case{"Post", BoxOf(5, 5, 6, 6), 0.8}, Case{"ThinFrame", Frame(), 0.8},
                    Case{"Block", BoxOf(5, 5, 8, 8), 0},
                    Case{"WallOnABlock", Union(BoxOf(5, 5, 8, 8), BoxOf(8, 6, 20, 7)), 0}),
    [](const auto& info) { return info.param.name; });

TEST(AroundSlender, PiecesThatDidNotStandStay) {
  const Bitmap walls = Of(Union(BoxOf(0, 5, 20, 6), BoxOf(0, 15, 20, 16)));
  const Bitmap around = AroundSlender(walls, Of(BoxOf(3, 5, 4, 6)), 900'000);
  EXPECT_GT(Mm2(around), 0);
  for (int32_t y = 0; y < kGrid.height; ++y)
    for (int32_t x = 0; x < kGrid.width; ++x)
      if (around.At(x, y)) {
        EXPECT_LT(kGrid.Centre(x, y).y, FromMm(10));
      }
}

}  // namespace
}  // namespace slicefarm::planning::slender_test
