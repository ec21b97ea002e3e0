#include "services/planning/algo/supports/generator/raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::raster_test {
namespace {

PixelGrid Grid(int32_t width, int32_t height) {
  return {{-1'000'000, 500'000}, 250'000, width, height};
}

TEST(PixelGrid, CoversItsBoxAndIsAligned) {
  const PixelGrid grid = GridOver({{-700'000, 10'000}, {1'000'001, 499'999}}, 250'000);
  EXPECT_EQ(grid.origin, (Point{-750'000, 0}));
  EXPECT_EQ(grid.width, 8);
  EXPECT_EQ(grid.height, 2);
  EXPECT_EQ(grid.Column(-700'000), 0);
  EXPECT_EQ(grid.Column(1'000'001), 7);
  EXPECT_EQ(grid.Column(-5'000'000), 0);
  EXPECT_EQ(grid.Row(9'000'000), 1);
}

TEST(Bitmap, SetsThePixelsWhoseCentresAreInside) {
  const MultiPolygon region = MakePolygonsOrDie(
      "(-0.6 0.7, 3 1.1, 2.2 3.3, 0 4) (0 1.5, 1 1.5, 1 2.5, 0 2.5); (5 5, 9 5, 9 9)");
  Bitmap bitmap(Grid(20, 16));
  bitmap.Fill(region);
  for (int32_t y = 0; y < 16; ++y) {
    for (int32_t x = 0; x < 20; ++x) {
      bool inside = false;
      for (const PolygonWithHoles& island : region)
        inside |= Locate(bitmap.grid().Centre(x, y), island) == Side::kInside;
      EXPECT_EQ(bitmap.At(x, y), inside) << x << " " << y;
    }
  }
}

TEST(Outline, GivesTheRegionBack) {
  const MultiPolygon frame = MakePolygonsOrDie("(0 1, 3 1, 3 4, 0 4) (1 2, 2 2, 2 3, 1 3)");
  Bitmap bitmap(Grid(30, 30));
  bitmap.Fill(frame);
  const MultiPolygon outline = Union(Outline(bitmap), FillRule::kPositive);
  EXPECT_TRUE(Difference(outline, frame).empty());
  EXPECT_TRUE(Difference(frame, outline).empty());
}

TEST(Outline, OfNoiseHasItsPixelsAndNoOthers) {
  std::mt19937 random(5);
  for (int round = 0; round < 20; ++round) {
    Bitmap bitmap(Grid(23, 17)), again(Grid(23, 17));
    size_t count = 0;
    for (size_t i = 0; i < bitmap.grid().size(); ++i)
      count += bitmap.Row(0)[i] = random() % 20 < static_cast<unsigned>(round) ? 1 : 0;
    const std::vector<Polygon> rings = Outline(bitmap);
    double area = 0;
    for (const Polygon& ring : rings) area += SignedArea(ring);
    EXPECT_EQ(area, static_cast<double>(count) * 62'500'000'000.0);
    for (const Polygon& ring : rings)
      for (size_t i = 0; i < ring.size(); ++i) {
        const Point a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
        EXPECT_NE(Cross(b - a, c - b), 0);
      }
  }
}

TEST(DistanceTo, EqualsBruteForce) {
  std::mt19937 random(7);
  for (const auto& [width, height, share] :
       {std::tuple{70, 33, 3}, {129, 20, 1}, {9, 90, 20}, {1, 1, 500}, {64, 64, 0}}) {
    Bitmap bitmap(Grid(width, height));
    for (int32_t y = 0; y < height; ++y)
      for (int32_t x = 0; x < width; ++x)
        bitmap.Row(y)[x] = static_cast<int>(random() % 1'000) < share ? 1 : 0;
    const auto distance = DistanceTo(bitmap);
    for (int32_t y = 0; y < height; ++y) {
      for (int32_t x = 0; x < width; ++x) {
        double least = 31;
        for (int32_t v = 0; v < height; ++v)
          for (int32_t u = 0; u < width; ++u)
            if (bitmap.At(u, v)) least = std::min(least, std::hypot(u - x, v - y));
        const double want =
            std::max(0.0, std::min<double>(kFarthest, std::round(8 * (least - 0.5))));
        ASSERT_EQ(distance[static_cast<size_t>(y * width + x)],
                  least == 0 ? 0 : static_cast<int>(want))
            << x << " " << y;
      }
    }
  }
}

}  // namespace
}  // namespace slicefarm::planning::raster_test
