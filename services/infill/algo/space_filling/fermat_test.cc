#include "services/infill/algo/space_filling/fermat.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/geometry/offset/clean_offset.h"
#include "services/infill/algo/space_filling/fill_checks_test.h"

namespace slicefarm::infill::fermat_test {
namespace {

constexpr Coord kSpacing = 450'000;

std::vector<Polyline> Fill(const PolygonWithHoles& region, Coord spacing = kSpacing) {
  auto paths = FermatFill(region, {.spacing_nm = spacing});
  EXPECT_TRUE(paths.ok()) << paths.status();
  return *std::move(paths);
}

double Covered(const std::vector<Polyline>& paths, double area) {
  return LengthOf(paths) * kSpacing / area;
}

// A strip between two and three lines wide can be covered neither by two lines nor by four. Comb
// and corridor are 6.67 lines wide and have six lines.
struct Case {
  const char* shape;
  double covered_low;
  double covered_high;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.shape; }
class Fermat : public testing::TestWithParam<Case> {};

TEST_P(Fermat, IsOnePathInside) {
  const PolygonWithHoles region = Shape(GetParam().shape);
  const auto paths = Fill(region);
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(CrossingsOf(paths), 0);
  EXPECT_LE(FarthestOutside(paths, FastOffset({region}, -kSpacing / 2), 100'000), 3);
  EXPECT_GE(Covered(paths, Area(region)), GetParam().covered_low);
  EXPECT_LE(Covered(paths, Area(region)), GetParam().covered_high);
}

TEST_P(Fermat, StartsAndEndsAtTheEdgeASpacingApart) {
  const PolygonWithHoles region = Shape(GetParam().shape);
  const auto paths = Fill(region);
  EXPECT_NEAR(DistanceToBoundary(paths[0].front(), {region}), kSpacing / 2, 5);
  EXPECT_LE(Distance(paths[0].front(), paths[0].back()), 1.02 * kSpacing);
}

TEST_P(Fermat, OfTurnedAndMirroredShapesIsAlike) {
  const MultiPolygon region = {Shape(GetParam().shape)};
  const auto paths = Fill(region[0]);
  EXPECT_EQ(paths, Fill(region[0]));
  for (const MultiPolygon& other : {QuarterTurned(region), Mirrored(region)}) {
    const auto others = Fill(other[0]);
    EXPECT_EQ(others.size(), 1U);
    EXPECT_NEAR(LengthOf(others) / LengthOf(paths), 1, 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Fermat,
                         testing::Values(Case{"square", 0.98, 1.02}, Case{"disc", 0.98, 1.02},
                                         Case{"annulus", 0.95, 1.05}, Case{"plate", 0.95, 1.05},
                                         Case{"comb", 0.85, 1.05}, Case{"star", 0.95, 1.05},
                                         Case{"eight", 0.95, 1.05}, Case{"corridor", 0.85, 1.05},
                                         Case{"sliver", 0.95, 1.15}),
                         [](const auto& info) { return std::string(info.param.shape); });

// Along rays from the middle, lines are a spacing apart, and the lines that lead inwards and
// outwards alternate.
TEST(FermatDisc, IsADoubleSpiralOfConstantSpacing) {
  const auto paths = Fill({Circle(0, 0, 20, 360), {}});
  ASSERT_EQ(paths.size(), 1U);
  const double half = Length(paths[0]) / 2;
  int pairs = 0, apart = 0, turns = 0;
  for (int ray = 0; ray < 12; ++ray) {
    const double t = 0.1 + ray * std::numbers::pi / 6;
    const Point end = {FromMm(21 * std::cos(t)), FromMm(21 * std::sin(t))};
    std::vector<std::pair<double, bool>> met;  // radius; true if the line leads inwards
    double length = 0;
    for (size_t i = 1; i < paths[0].size(); ++i) {
      const Point a = paths[0][i - 1], b = paths[0][i];
      if (Orientation({0, 0}, end, a) * Orientation({0, 0}, end, b) < 0 && Dot(a, end) > 0) {
        const double part = Cross(a, end) / Cross(a - b, end);
        const double x = static_cast<double>(a.x) + part * static_cast<double>(b.x - a.x);
        const double y = static_cast<double>(a.y) + part * static_cast<double>(b.y - a.y);
        met.emplace_back(std::sqrt(x * x + y * y), length < half);
      }
      length += Distance(a, b);
    }
    std::sort(met.rbegin(), met.rend());
    ASSERT_GE(met.size(), 40U);
    for (size_t i = 1; i + 4 < met.size(); ++i) {
      ++pairs;
      const double gap = met[i - 1].first - met[i].first;
      apart += std::abs(gap - kSpacing) <= 0.01 * kSpacing ? 1 : 0;
      turns += met[i].second != met[i - 1].second ? 1 : 0;
    }
  }
  // The exceptions are at the seam.
  EXPECT_GE(pairs, 12 * 37);
  EXPECT_GE(apart, pairs * 95 / 100);
  EXPECT_GE(turns, pairs * 90 / 100);
}

TEST(FermatDisc, LengthIsAreaOverSpacing) {
  const PolygonWithHoles disc = {Circle(0, 0, 20, 720), {}};
  EXPECT_NEAR(LengthOf(Fill(disc, 400'000)) * 400'000 / Area(disc), 1, 0.003);
}

// The regions are opened by a disc of two lines' width, so that they are two lines wide everywhere.
TEST(FermatRandom, OnePathForEachRegionTwoLinesWide) {
  std::mt19937 random(17);
  double length = 0, area = 0;
  int regions = 0, holes = 0;
  for (int i = 0; i < 250; ++i) {
    const MultiPolygon island = RandomIsland(random, {0, 0}, Uniform(random, 2, 15));
    for (const PolygonWithHoles& region : TwoLinesWide(island, kSpacing)) {
      const auto paths = Fill(region);
      ++regions;
      holes += region.holes.empty() ? 0 : 1;
      EXPECT_EQ(paths.size(), 1U) << i;
      EXPECT_EQ(CrossingsOf(paths), 0) << i;
      EXPECT_LE(FarthestOutside(paths, FastOffset({region}, -kSpacing / 2), 300'000), 3) << i;
      length += LengthOf(paths);
      area += Area(region);
    }
  }
  EXPECT_GE(regions, 200);
  EXPECT_GE(holes, 50);
  EXPECT_NEAR(length * kSpacing / area, 1, 0.05);
}

// Regions with slivers, spikes and touching parts: each part has one path, and no paths cross.
TEST(FermatRandom, AsTheyCome) {
  std::mt19937 random(19);
  for (int i = 0; i < 400; ++i) {
    for (const PolygonWithHoles& region :
         RandomIsland(random, {-3'000'000, 5'000'000}, Uniform(random, 0.3, 8))) {
      const auto paths = Fill(region);
      const MultiPolygon parts = FastOffset({region}, -kSpacing / 2);
      EXPECT_LE(paths.size(), parts.size()) << i;
      EXPECT_EQ(CrossingsOf(paths), 0) << i;
      EXPECT_LE(FarthestOutside(paths, parts, 300'000), 3) << i;
    }
  }
}

TEST(FermatCorpus, OnePathForEachPart) {
  double length = 0, area = 0;
  size_t paths_count = 0, parts_count = 0;
  for (const char* name : kCorpusSlices) {
    for (const PolygonWithHoles& region : CorpusSlice(name)) {
      const auto paths = Fill(region);
      EXPECT_EQ(CrossingsOf(paths), 0) << name;
      paths_count += paths.size();
      parts_count += FastOffset({region}, -kSpacing / 2).size();
      length += LengthOf(paths);
      area += Area(region);
    }
  }
  EXPECT_LE(paths_count, parts_count);
  EXPECT_NEAR(length * kSpacing / area, 1, 0.05);
}

TEST(FermatErrors, AreTyped) {
  EXPECT_EQ(DetailOf(FermatFill(Shape("square"), {.spacing_nm = 0}).status()).reason,
            Reason::kSettingOutOfRange);
  EXPECT_EQ(DetailOf(FermatFill(Shape("square"), {.spacing_nm = 10}).status()).reason,
            Reason::kRequestTooLarge);
  EXPECT_TRUE(FermatFill({}, {})->empty());
}

}  // namespace
}  // namespace slicefarm::infill::fermat_test
