#include "common/geometry/boolean/without_rings.h"

#include <gtest/gtest.h>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::without_rings_test {
namespace {

double AreaMm2(const MultiPolygon& polygons) { return Area(polygons) / 1e12; }

TEST(WithoutRings, RingsMayOverlap) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  std::vector<Polygon> rings = Rings(MakePolygonsOrDie("(-1 -1, 4 -1, 4 11, -1 11)"));
  for (const Polygon& ring : Rings(MakePolygonsOrDie("(3 -1, 6 -1, 6 11, 3 11)")))
    rings.push_back(ring);
  const MultiPolygon rest = WithoutRings(region, rings);
  EXPECT_EQ(AreaMm2(rest), 40);
  EXPECT_EQ(WithoutRings(region, {}), region);
  EXPECT_TRUE(WithoutRings(MultiPolygon(), rings).empty());
}

TEST(WithoutRings, HolesOfOneRegionAreFilledByAnother) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  std::vector<Polygon> rings =
      Rings(MakePolygonsOrDie("(-1 -1, 11 -1, 11 11, -1 11) (2 2, 8 2, 8 8, 2 8)"));
  EXPECT_EQ(AreaMm2(WithoutRings(region, rings)), 36);
  rings.push_back(MakePolygonsOrDie("(4 1, 9 1, 9 9, 4 9)")[0].outer);
  EXPECT_EQ(AreaMm2(WithoutRings(region, rings)), 12);
}

/// A comb, and boxes around all its teeth: the result inside each box must not change.
TEST(AppendRingsNear, MeansTheSameInsideTheBox) {
  const MultiPolygon comb = MakePolygonsOrDie(
      "(0 0, 30 0, 30 20, 28 20, 28 2, 24 2, 24 20, 20 20, 20 2, 16 2, 16 20, 12 20, 12 2, 8 2, "
      "8 20, 4 20, 4 2, 2 2, 2 20, 0 20) (5 0.5, 25 0.5, 25 1.5, 5 1.5)");
  for (Coord x = -4; x < 34; x += 3) {
    for (Coord y = -4; y < 24; y += 3) {
      const Point low = {x * kNmPerMm, y * kNmPerMm};
      const Point high = {low.x + 2'500'000, low.y + 2'500'000};
      std::vector<Polygon> rings;
      AppendRingsNear(comb, Box{low, high}.Grown(100'000), rings);
      const MultiPolygon box = {{{low, {high.x, low.y}, high, {low.x, high.y}}, {}}};
      EXPECT_EQ(WithoutRings(box, rings), WithoutRings(box, Rings(comb))) << x << " " << y;
    }
  }
}

TEST(AppendRingsNear, LeavesOutWhatIsFarAndShortensTheRest) {
  Polygon ring;  // a long wavy strip
  for (int i = 0; i < 1'000; ++i) ring.push_back({i * kNmPerMm, (i % 2) * kNmPerMm});
  for (int i = 999; i >= 0; --i) ring.push_back({i * kNmPerMm, (10 + i % 2) * kNmPerMm});
  std::vector<Polygon> rings;
  AppendRingsNear({{ring, {}}}, Box{{500 * kNmPerMm, 0}, {510 * kNmPerMm, kNmPerMm}}, rings);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_LT(rings[0].size(), 40u);
  rings.clear();
  AppendRingsNear({{ring, {}}}, Box{{0, 20 * kNmPerMm}, {kNmPerMm, 30 * kNmPerMm}}, rings);
  EXPECT_TRUE(rings.empty());
}

}  // namespace
}  // namespace slicefarm::without_rings_test
