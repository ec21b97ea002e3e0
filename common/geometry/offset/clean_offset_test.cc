#include "common/geometry/offset/clean_offset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "common/geometry/boolean/boolean.h"
#include "common/geometry/boolean/clipper_oracle_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::clean_offset_test {
namespace {

MultiPolygon PolygonsOf(std::string_view text) {
  MultiPolygon polygons = MakePolygonsOrDie(text);
  Canonicalize(polygons);
  return polygons;
}
double AreaInMm2(const MultiPolygon& polygons) { return Area(polygons) / 1e12; }

TEST(CleanOffset, Squares) {
  const MultiPolygon square = PolygonsOf("(0 0, 10 0, 10 10, 0 10)");
  EXPECT_EQ(TryOffset(square, FromMm(-1))->polygons, PolygonsOf("(1 1, 9 1, 9 9, 1 9)"));
  EXPECT_EQ(TryOffset(square, FromMm(1))->polygons, PolygonsOf("(-1 -1, 11 -1, 11 11, -1 11)"));
  const MultiPolygon frame = PolygonsOf("(0 0, 10 0, 10 10, 0 10) (3 3, 7 3, 7 7, 3 7)");
  EXPECT_EQ(TryOffset(frame, FromMm(-1))->polygons,
            PolygonsOf("(1 1, 9 1, 9 9, 1 9) (2 2, 8 2, 8 8, 2 8)"));
}

struct DirtyCase {
  std::string name;
  std::string text;
  double distance_mm;
};
class Dirty : public testing::TestWithParam<DirtyCase> {};

TEST_P(Dirty, IsLeftToOthers) {
  EXPECT_FALSE(TryOffset(PolygonsOf(GetParam().text), FromMm(GetParam().distance_mm)).has_value());
}

INSTANTIATE_TEST_SUITE_P(
    CleanOffset, Dirty,
    testing::Values(
        DirtyCase{"Vanishes", "(0 0, 10 0, 10 10, 0 10)", -6},
        DirtyCase{"TriangleTurnsInsideOut", "(0 0, 10 0, 5 8)", -4},
        DirtyCase{"NeckSplits",
                  "(0 0, 4 0, 4 1.5, 6 1.5, 6 0, 10 0, 10 4, 6 4, 6 2.5, 4 2.5, 4 4, 0 4)", -0.7},
        DirtyCase{"FrameIsTooThin", "(0 0, 10 0, 10 10, 0 10) (1 1, 9 1, 9 9, 1 9)", -2},
        DirtyCase{"HoleOutgrowsItsIsland", "(0 0, 10 0, 10 10, 0 10) (1 1, 9 1, 9 9, 1 9)", -3},
        DirtyCase{"HolesMeet", "(0 0, 20 0, 20 10, 0 10) (4 4, 6 4, 6 6, 4 6) (7 4, 9 4, 9 6, 7 6)",
                  -0.6},
        DirtyCase{"IslandsMeet", "(0 0, 4 0, 4 4, 0 4) ; (5 0, 9 0, 9 4, 5 4)", 0.6},
        DirtyCase{"HoleCloses", "(0 0, 10 0, 10 10, 0 10) (4 4, 6 4, 6 6, 4 6)", 1.1}),
    [](const auto& info) { return info.param.name; });

TEST(CleanOffset, TellsTips) {
  EXPECT_TRUE(TryOffset(PolygonsOf("(0 0, 20 -4, 20 4)"), FromMm(-0.5))->has_tips);
  EXPECT_FALSE(TryOffset(PolygonsOf("(0 0, 10 0, 10 10, 0 10)"), FromMm(-0.5))->has_tips);
}

TEST(Erode, SplitsAndSwallows) {
  const MultiPolygon dumbbell = PolygonsOf(
      "(0 0, 4 0, 4.1 1.5, 6 1.6, 6.1 0, 10 0, 10 4, 6.2 4, 6.1 2.5, 4.2 2.4, 3.9 4, 0 4)");
  const auto eroded = TryErode(dumbbell[0], FromMm(0.7));
  ASSERT_TRUE(eroded.has_value());
  EXPECT_EQ(eroded->size(), 2u);
  EXPECT_LT(Apart(*eroded, ClipperOffset(dumbbell, FromMm(-0.7))), 1e-5);
  // Distances far above the radius of the inscribed circle give no result, and no leftover of a
  // ring that was turned inside out.
  for (const double mm : {2.3, 3.1, 5.3, 11.7})
    EXPECT_TRUE(FastOffset(dumbbell, FromMm(-mm)).empty()) << mm;
}

/// Returns a ring with waves and teeth; if `fine`, with many points between them.
Polygon Blob(std::mt19937& random, bool fine) {
  std::uniform_real_distribution<double> unit(0, 1);
  Polygon ring;
  const int points = fine ? 200 : 20 + static_cast<int>(30 * unit(random));
  const int waves = 2 + static_cast<int>(9 * unit(random));
  const double depth = 0.6 * unit(random), noise = fine ? 0 : 0.3 * unit(random);
  for (int i = 0; i < points; ++i) {
    const double t = 2 * std::numbers::pi * i / points;
    const double r = 5 * (1 + depth * std::sin(waves * t) + noise * unit(random));
    ring.push_back({FromMm(r * std::cos(t)), FromMm(r * std::sin(t))});
  }
  return ring;
}

// For any shape and distance, the result is the same region as Clipper's.
TEST(FastOffset, EqualsClippers) {
  std::mt19937 random(11);
  int eroded = 0, clean = 0;
  for (int i = 0; i < 200; ++i) {
    const MultiPolygon region =
        Union(std::vector<Polygon>{Blob(random, i % 3 == 0)}, FillRule::kPositive);
    for (const double mm : {-0.1, -0.4, -1.1, -2.3, -4.0, -9.0, 0.2, 0.7}) {
      const MultiPolygon want = ClipperOffset(region, FromMm(mm)),
                         got = FastOffset(region, FromMm(mm));
      double perimeter = 0;
      for (const Polygon& ring : Rings(want)) perimeter += Perimeter(ring) / kNmPerMm;
      EXPECT_LT(Apart(got, want), 1e-5 * (1 + perimeter)) << i << " " << mm;
      clean += TryOffset(region, FromMm(mm)).has_value();
      if (mm < 0 && region.size() == 1) eroded += TryErode(region[0], FromMm(-mm)).has_value();
    }
  }
  EXPECT_GT(clean, 400);
  EXPECT_GT(eroded, 800);
}

TEST(FastOffset, TurnsWithTheRegion) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const MultiPolygon region = {{Blob(random, false), {}}};
    MultiPolygon turned = region;
    for (Point& p : turned[0].outer) p = {-p.y, p.x};
    EXPECT_NEAR(AreaInMm2(FastOffset(region, FromMm(-0.5))),
                AreaInMm2(FastOffset(turned, FromMm(-0.5))), 1e-6);
  }
}

}  // namespace
}  // namespace slicefarm::clean_offset_test
