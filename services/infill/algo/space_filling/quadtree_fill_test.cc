#include "services/infill/algo/space_filling/quadtree_fill.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/infill/algo/space_filling/fill_checks_test.h"

namespace slicefarm::infill::quadtree_fill_test {
namespace {

constexpr Coord kSpacing = 450'000;

struct Curve {
  const char* name;
  absl::StatusOr<std::vector<Polyline>> (*fill)(const PolygonWithHoles&, const QuadtreeOptions&);
};
constexpr Curve kCurves[] = {{"Hilbert", HilbertFill}, {"Peano", PeanoFill}};

std::vector<Polyline> Fill(const Curve& curve, const PolygonWithHoles& region) {
  auto paths = curve.fill(region, {.spacing_nm = kSpacing});
  EXPECT_TRUE(paths.ok()) << paths.status();
  return *std::move(paths);
}

struct Case {
  Curve curve;
  const char* shape;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.curve.name << c.shape; }
class Quadtree : public testing::TestWithParam<Case> {};

TEST_P(Quadtree, IsOnePathInside) {
  const PolygonWithHoles region = Shape(GetParam().shape);
  const auto paths = Fill(GetParam().curve, region);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(CrossingsOf(paths), 0);
  EXPECT_LE(FarthestOutside(paths, FastOffset({region}, -kSpacing / 2), 100'000), 3);
  EXPECT_NEAR(LengthOf(paths) * kSpacing / Area(region), 1, 0.1);
  EXPECT_NEAR(DistanceToBoundary(paths[0].front(), {region}), kSpacing / 2, 5);
  EXPECT_EQ(paths, Fill(GetParam().curve, region));
}

TEST_P(Quadtree, OfTurnedAndMirroredShapesIsAlike) {
  const MultiPolygon region = {Shape(GetParam().shape)};
  const double length = LengthOf(Fill(GetParam().curve, region[0]));
  for (const MultiPolygon& other : {QuarterTurned(region), Mirrored(region)}) {
    const auto others = Fill(GetParam().curve, other[0]);
    EXPECT_EQ(others.size(), 1U);
    EXPECT_NEAR(LengthOf(others) / length, 1, 0.05);
  }
}

std::vector<Case> Cases() {
  std::vector<Case> cases;
  for (const Curve& curve : kCurves)
    for (const char* shape :
         {"square", "disc", "annulus", "plate", "comb", "star", "eight", "corridor", "sliver"})
      cases.push_back({curve, shape});
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Shapes, Quadtree, testing::ValuesIn(Cases()), [](const auto& info) {
  return std::string(info.param.curve.name) + info.param.shape;
});

// A small square in the middle of a large square's fill contains only the curve itself: all lines
// are on the grid of half cells, and each length is a multiple of the spacing.
TEST(QuadtreeSquare, CurveRunsOnTheGrid) {
  for (const Curve& curve : kCurves) {
    const auto paths = Fill(curve, MakePolygonsOrDie("(-30 -30, 30 -30, 30 30, -30 30)")[0]);
    ASSERT_EQ(paths.size(), 1U);
    double length = 0;
    for (size_t i = 1; i < paths[0].size(); ++i) {
      const Point a = paths[0][i - 1], b = paths[0][i];
      if (std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y)}) > 25'000'000)
        continue;
      EXPECT_TRUE(a.x == b.x || a.y == b.y);
      for (const Point p : {a, b}) {
        EXPECT_EQ((p.x - kSpacing / 2) % kSpacing, 0);
        EXPECT_EQ((p.y - kSpacing / 2) % kSpacing, 0);
      }
      length += Distance(a, b);
    }
    EXPECT_NEAR(length * kSpacing / 50e6 / 50e6, 1, 0.04) << curve.name;
    EXPECT_NEAR(LengthOf(paths) * kSpacing / 60e6 / 60e6, 1, 0.03) << curve.name;
  }
}

TEST(QuadtreeRandom, OnePathForEachRegionTwoLinesWide) {
  for (const Curve& curve : kCurves) {
    std::mt19937 random(23);
    double length = 0, area = 0;
    int regions = 0, holes = 0;
    for (int i = 0; i < 150; ++i) {
      const MultiPolygon island = RandomIsland(random, {0, 0}, Uniform(random, 2, 15));
      for (const PolygonWithHoles& region : TwoLinesWide(island, kSpacing)) {
        const auto paths = Fill(curve, region);
        ++regions;
        holes += region.holes.empty() ? 0 : 1;
        EXPECT_EQ(paths.size(), 1U) << curve.name << i;
        EXPECT_EQ(CrossingsOf(paths), 0) << curve.name << i;
        EXPECT_LE(FarthestOutside(paths, FastOffset({region}, -kSpacing / 2), 300'000), 3) << i;
        length += LengthOf(paths);
        area += Area(region);
      }
    }
    EXPECT_GE(regions, 120);
    EXPECT_GE(holes, 30);
    EXPECT_NEAR(length * kSpacing / area, 1, 0.05);
  }
}

TEST(QuadtreeCorpus, OnePathForEachPart) {
  for (const Curve& curve : kCurves) {
    double length = 0, area = 0;
    for (const char* name : kCorpusSlices) {
      for (const PolygonWithHoles& region : CorpusSlice(name)) {
        const auto paths = Fill(curve, region);
        EXPECT_LE(paths.size(), FastOffset({region}, -kSpacing / 2).size()) << name;
        EXPECT_EQ(CrossingsOf(paths), 0) << name;
        length += LengthOf(paths);
        area += Area(region);
      }
    }
    EXPECT_NEAR(length * kSpacing / area, 1, 0.05) << curve.name;
  }
}

TEST(QuadtreeErrors, AreTyped) {
  for (const Curve& curve : kCurves) {
    EXPECT_EQ(DetailOf(curve.fill(Shape("square"), {.spacing_nm = -5}).status()).reason,
              Reason::kSettingOutOfRange);
    EXPECT_EQ(DetailOf(curve.fill(Shape("square"), {.spacing_nm = 10}).status()).reason,
              Reason::kRequestTooLarge);
    EXPECT_TRUE(curve.fill({}, {})->empty());
  }
}

}  // namespace
}  // namespace slicefarm::infill::quadtree_fill_test
