#include "services/planning/algo/supports/generator/tips.h"

#include <gtest/gtest.h>

#include "services/planning/algo/supports/generator/problems_test.h"

namespace slicefarm::planning::tips_test {
namespace {

constexpr Coord kReach = 1'200'000;

/// Returns the pixels of a region.
std::vector<int32_t> Pixels(const PixelGrid& grid, const MultiPolygon& region) {
  Bitmap bitmap(grid);
  bitmap.Fill(region);
  std::vector<int32_t> pixels;
  for (size_t i = 0; i < grid.size(); ++i)
    if (bitmap.Row(0)[i]) pixels.push_back(static_cast<int32_t>(i));
  return pixels;
}

const PixelGrid kGrid = GridOver({{0, 0}, {20'000'000, 20'000'000}}, 250'000);

/// Returns the distance of a point from the nearest tip; 0 near a line between two tips that a
/// sheet spans.
double FromTips(Point p, const std::vector<Point>& tips) {
  double nearest = 1e9;
  for (size_t i = 0; i < tips.size(); ++i) {
    nearest = std::min(nearest, Distance(p, tips[i]));
    for (size_t k = 0; k < i; ++k)
      if (Distance(tips[i], tips[k]) <= TipFinder::kSpanNm &&
          DistanceToSegment(p, tips[i], tips[k]) <= 800'000)
        return 0;
  }
  return nearest;
}

TEST(TipFinder, EverythingIsWithinReachOfATip) {
  for (const MultiPolygon& region : {BoxOf(1, 1, 2, 2), BoxOf(1, 1, 19, 1.6), BoxOf(3, 3, 17, 17),
                                     Difference(BoxOf(1, 1, 19, 19), BoxOf(2, 2, 18, 18))}) {
    const auto underside = Pixels(kGrid, region);
    TipFinder places(kGrid, kReach);
    places.Begin(underside);
    const std::vector<Point> tips = places.Place();
    for (const int32_t i : underside) {
      const Point p = kGrid.Centre(i % kGrid.width, i / kGrid.width);
      EXPECT_LE(FromTips(p, tips), kReach);
    }
    EXPECT_LE(tips.size(), 2 + AreaMm2(region) * 0.6);
  }
}

TEST(TipFinder, WhatIsCoveredNeedsNone) {
  TipFinder places(kGrid, kReach);
  places.Begin(Pixels(kGrid, BoxOf(5, 5, 6, 6)));
  places.Cover({5'500'000, 5'500'000}, 1'000'000);
  EXPECT_TRUE(places.Place().empty());
  places.Begin(Pixels(kGrid, BoxOf(5, 5, 6, 6)));
  EXPECT_EQ(places.Place(), std::vector<Point>({{5'375'000, 5'375'000}}));
}

}  // namespace
}  // namespace slicefarm::planning::tips_test
