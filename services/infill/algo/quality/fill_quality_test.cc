#include "services/infill/algo/quality/fill_quality.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "services/infill/algo/solid.h"
#include "services/infill/algo/space_filling/hilbert.h"
#include "services/infill/algo/space_filling/peano.h"
#include "services/infill/algo/sparse.h"

namespace slicefarm::infill::fill_quality_test {
namespace {

constexpr Coord kFlat = 1;  ///< height at which beads have straight sides

Path LineOf(std::initializer_list<Point> mm) {
  Path path;
  for (const Point p : mm) path.points.push_back({p.x * kNmPerMm, p.y * kNmPerMm});
  path.widths_nm = {kNmPerMm};
  return path;
}

Path CurveOf(std::span<const CurveCell> cells) {
  Path path;
  for (const CurveCell& cell : cells)
    path.points.push_back({Coord{cell.x} * kNmPerMm, Coord{cell.y} * kNmPerMm});
  path.widths_nm = {kNmPerMm};
  return path;
}

TEST(FillQuality, CountsWhatThereIs) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)");
  const std::vector<Path> paths = {LineOf({{0, 1}, {10, 1}}), LineOf({{0, 4}, {10, 4}}),
                                   LineOf({{20, 20}, {20, 25}})};
  const FillQuality quality = QualityOf(region, paths, kFlat, kNmPerMm);
  EXPECT_EQ(quality.paths, 3);
  EXPECT_NEAR(quality.length_mm, 25, 1e-9);
  EXPECT_NEAR(quality.longest_mm, 10, 1e-9);
  EXPECT_NEAR(quality.got, 0.25, 1e-6);
  EXPECT_NEAR(quality.covered, 0.2, 1e-6);
  EXPECT_NEAR(quality.travel_mm, 3 + std::hypot(20, 16), 1e-6);
  EXPECT_NEAR(quality.isotropy, 5.0 / 20, 1e-9);
}

TEST(FillQuality, OfNothingIsNothing) {
  const FillQuality none = QualityOf({}, {}, kFlat, kNmPerMm);
  EXPECT_EQ(none.paths, 0);
  EXPECT_EQ(none.got, 0);
  EXPECT_EQ(none.locality, 0);
}

// Known values: the steps of Hilbert's curve are evenly distributed over directions, Peano's three
// to one.
TEST(FillQuality, TellsCurvesApart) {
  std::vector<CurveCell> hilbert, peano;
  for (int i = 0; i < 1024; ++i) hilbert.push_back(HilbertCell(5, i));
  for (int i = 0; i < 729; ++i) peano.push_back(PeanoCell(3, i));
  const std::vector<Path> h = {CurveOf(hilbert)}, p = {CurveOf(peano)};
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 32 0, 32 32, 0 32)");
  EXPECT_NEAR(QualityOf(square, h, kFlat, kNmPerMm).isotropy, 511.0 / 512, 1e-9);
  EXPECT_NEAR(QualityOf(square, h, kFlat, kNmPerMm).locality, 5.2325581, 1e-6);
  EXPECT_NEAR(QualityOf(square, p, kFlat, kNmPerMm).isotropy, 182.0 / 546, 1e-9);
  EXPECT_NEAR(QualityOf(square, p, kFlat, kNmPerMm).locality, 7.0487805, 1e-6);
}

TEST(FillQuality, SolidCoversAndSparseGetsItsDensity) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 40 0, 40 40, 0 40)");
  const auto solid = FillSolid(region[0], {.height_nm = kFlat, .overlap_nm = 112'500});
  ASSERT_TRUE(solid.ok());
  EXPECT_GT(QualityOf(region, solid->paths, kFlat, 450'000).covered, 0.99);
  const auto gyroid = FillSparse(region, {.pattern = FillPattern::kTriangles, .height_nm = kFlat});
  ASSERT_TRUE(gyroid.ok());
  const FillQuality quality = QualityOf(region, *gyroid, kFlat, 450'000);
  EXPECT_NEAR(quality.got, 0.2, 0.02);
  EXPECT_GT(quality.isotropy, 0.9);
}

TEST(PropertyBounds, AreThoseOfTheBooks) {
  EXPECT_DOUBLE_EQ(StiffnessBounds(0.3).most, 0.3);
  EXPECT_DOUBLE_EQ(StiffnessBounds(0.3).least, 0.09);
  const PropertyBounds heat = ConductivityBounds(0.3, 0.2, 0.026);
  EXPECT_NEAR(heat.most, 0.0782, 1e-9);
  EXPECT_NEAR(heat.least, 0.0351827, 1e-7);
  EXPECT_DOUBLE_EQ(ConductivityBounds(1, 0.2, 0.026).least, 0.2);
}

}  // namespace
}  // namespace slicefarm::infill::fill_quality_test
