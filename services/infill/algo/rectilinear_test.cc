#include "services/infill/algo/rectilinear.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/geometry/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset.h"
#include "common/geometry/text_format.h"
#include "common/model/bead_section.h"

namespace slicefarm::infill {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

double LengthIn(const std::vector<Path>& paths, const MultiPolygon& region) {
  std::vector<Polyline> lines;
  for (const Path& path : paths) lines.push_back(path.points);
  double length = 0;
  for (const Polyline& line : ClipLines(lines, region)) length += Length(line);
  return length;
}

struct DensityCase {
  SparsePattern pattern;
  double density;
};
class Density : public testing::TestWithParam<DensityCase> {};

// Length of lines times spacing is density times area, two widths inside.
TEST_P(Density, IsAsAsked) {
  const MultiPolygon box = P("(20 30, 220 30, 220 230, 20 230)");
  SparseFill fill{.pattern = GetParam().pattern,
                  .density = GetParam().density,
                  .angle_rad = std::numbers::pi / 4,
                  .overlap_nm = 112'500};
  const auto paths = FillSparse(box, fill);
  ASSERT_TRUE(paths.ok());
  const double spacing = static_cast<double>(Spacing(fill.width_nm, fill.height_nm));
  const MultiPolygon inner = Offset(box, -2 * fill.width_nm);
  EXPECT_NEAR(LengthIn(*paths, inner) * spacing / Area(inner) / fill.density, 1, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Sparse, Density,
                         testing::Values(DensityCase{SparsePattern::kRectilinear, 0.1},
                                         DensityCase{SparsePattern::kRectilinear, 0.2},
                                         DensityCase{SparsePattern::kRectilinear, 0.4},
                                         DensityCase{SparsePattern::kRectilinear, 0.6},
                                         DensityCase{SparsePattern::kRectilinear, 0.8},
                                         DensityCase{SparsePattern::kGrid, 0.05},
                                         DensityCase{SparsePattern::kGrid, 0.1},
                                         DensityCase{SparsePattern::kGrid, 0.2},
                                         DensityCase{SparsePattern::kGrid, 0.4},
                                         DensityCase{SparsePattern::kGrid, 0.8}));

TEST(Sparse, LinesOfAllRegionsLieOnOneGrid) {
  const SparseFill fill{.pattern = SparsePattern::kRectilinear};
  const double pitch = static_cast<double>(Spacing(450'000, 200'000)) / 0.2;
  for (const char* text : {"(0 0, 30 0, 30 30, 0 30)", "(41 7, 60 3, 77 31)"}) {
    const auto paths = FillSparse(P(text), fill);
    ASSERT_TRUE(paths.ok());
    for (const Path& path : *paths) {
      for (size_t i = 1; i < path.points.size(); ++i) {
        if (path.points[i].y != path.points[i - 1].y) continue;
        const double rows = static_cast<double>(path.points[i].y) / pitch;
        EXPECT_NEAR(rows, std::round(rows), 1e-5);
      }
    }
  }
}

TEST(Sparse, ConvexRegionIsOnePathPerDirection) {
  EXPECT_EQ(FillSparse(P("(0 0, 30 0, 30 30, 0 30)"),
                       {.pattern = SparsePattern::kRectilinear, .angle_rad = 0})
                ->size(),
            1u);
  EXPECT_EQ(
      FillSparse(P("(0 0, 30 0, 30 30, 0 30)"), {.pattern = SparsePattern::kGrid, .angle_rad = 0})
          ->size(),
      2u);
}

TEST(Sparse, RectilinearTurnsWithTheLayer) {
  const MultiPolygon box = P("(0 0, 30 0, 30 30, 0 30)");
  SparseFill fill{.pattern = SparsePattern::kRectilinear};
  const auto even = FillSparse(box, fill);
  fill.layer_index = 1;
  const auto odd = FillSparse(box, fill);
  EXPECT_EQ((*even)[0].points[0].y, (*even)[0].points[1].y);
  EXPECT_EQ((*odd)[0].points[0].x, (*odd)[0].points[1].x);
}

TEST(Sparse, NothingAtNoDensityAndInNothing) {
  EXPECT_TRUE(FillSparse(P("(0 0, 30 0, 30 30, 0 30)"), {.density = 0})->empty());
  EXPECT_TRUE(FillSparse({}, {})->empty());
}

TEST(Sparse, StaysInside) {
  const MultiPolygon region = P("(0 0, 30 0, 30 30, 15 5, 0 30) (3 2, 5 2, 5 4, 3 4)");
  for (const double angle : {0.0, 0.4, 0.8, 1.57}) {
    const auto paths =
        FillSparse(region, {.density = 0.3, .angle_rad = angle, .overlap_nm = 225'000});
    double length = 0;
    for (const Path& path : *paths) length += PathLength(path);
    EXPECT_NEAR(LengthIn(*paths, Offset(region, 10'000)), length, 1e3);
  }
}

}  // namespace
}  // namespace slicefarm::infill
