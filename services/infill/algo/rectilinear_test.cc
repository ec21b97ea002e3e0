#include "services/infill/algo/rectilinear.h"

#include <gtest/gtest.h>

#include <numbers>

#include "common/geometry/clean_offset.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset.h"
#include "common/geometry/text_format.h"
#include "common/model/bead_section.h"

namespace slicefarm::infill {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

/// Length of the paths inside a box.
double LengthIn(const std::vector<Path>& paths, const Box& box) {
  const auto part = [&](Point a, Point b) {
    double from = 0, to = 1;
    const auto clip = [&](Coord start, Coord way, Coord low, Coord high) {
      if (way == 0) {
        if (start < low || start > high) to = from;
        return;
      }
      double in = static_cast<double>(low - start) / static_cast<double>(way);
      double out = static_cast<double>(high - start) / static_cast<double>(way);
      if (in > out) std::swap(in, out);
      from = std::max(from, in), to = std::min(to, out);
    };
    clip(a.x, b.x - a.x, box.min.x, box.max.x);
    clip(a.y, b.y - a.y, box.min.y, box.max.y);
    return std::max(0.0, to - from) * Distance(a, b);
  };
  double length = 0;
  for (const Path& path : paths)
    for (size_t i = 1; i < path.points.size(); ++i)
      length += part(path.points[i - 1], path.points[i]);
  return length;
}

struct DensityCase {
  SparsePattern pattern;
  double density;
  double angle_deg;
};
class Density : public testing::TestWithParam<DensityCase> {};

// Length of lines times spacing is density times area: to 1 % two widths inside, to 3 % in all.
// Averaged over places of the region on the grid.
TEST_P(Density, IsAsAsked) {
  SparseFill fill{.pattern = GetParam().pattern,
                  .density = GetParam().density,
                  .angle_rad = GetParam().angle_deg * std::numbers::pi / 180,
                  .overlap_nm = 112'500};
  const auto spacing = static_cast<double>(Spacing(fill.width_nm, fill.height_nm));
  double inner_length = 0, inner_area = 0, length = 0, area = 0;
  for (Coord i = 0; i < 37; ++i) {
    MultiPolygon box = P("(0 0, 80 0, 80 80, 0 80)");
    const Coord shift = std::llround(static_cast<double>(2 * i) / 37 * spacing / fill.density);
    for (Point& p : box[0].outer) p = p + Point{shift, 2 * shift};
    const auto paths = FillSparse(box, fill);
    ASSERT_TRUE(paths.ok());
    const MultiPolygon inner = FastOffset(box, -2 * fill.width_nm);
    inner_length += LengthIn(*paths, Bounds(inner)), inner_area += Area(inner);
    length += LengthIn(*paths, Bounds(box)), area += Area(box);
  }
  EXPECT_NEAR(inner_length * spacing / inner_area / fill.density, 1, 0.01);
  EXPECT_NEAR(length * spacing / area / fill.density, 1, 0.03);
}

INSTANTIATE_TEST_SUITE_P(
    Sparse, Density,
    testing::Values(
        DensityCase{SparsePattern::kRectilinear, 0.05, 0},
        DensityCase{SparsePattern::kRectilinear, 0.05, 45},
        DensityCase{SparsePattern::kRectilinear, 0.1, 0},
        DensityCase{SparsePattern::kRectilinear, 0.1, 45},
        DensityCase{SparsePattern::kRectilinear, 0.15, 0},
        DensityCase{SparsePattern::kRectilinear, 0.15, 45},
        DensityCase{SparsePattern::kRectilinear, 0.2, 0},
        DensityCase{SparsePattern::kRectilinear, 0.2, 45},
        DensityCase{SparsePattern::kRectilinear, 0.4, 0},
        DensityCase{SparsePattern::kRectilinear, 0.4, 45},
        DensityCase{SparsePattern::kRectilinear, 0.6, 0},
        DensityCase{SparsePattern::kRectilinear, 0.6, 45},
        DensityCase{SparsePattern::kRectilinear, 0.8, 0},
        DensityCase{SparsePattern::kRectilinear, 0.8, 45},
        DensityCase{SparsePattern::kGrid, 0.05, 0}, DensityCase{SparsePattern::kGrid, 0.05, 45},
        DensityCase{SparsePattern::kGrid, 0.1, 0}, DensityCase{SparsePattern::kGrid, 0.1, 45},
        DensityCase{SparsePattern::kGrid, 0.15, 0}, DensityCase{SparsePattern::kGrid, 0.15, 45},
        DensityCase{SparsePattern::kGrid, 0.2, 0}, DensityCase{SparsePattern::kGrid, 0.2, 45},
        DensityCase{SparsePattern::kGrid, 0.4, 0}, DensityCase{SparsePattern::kGrid, 0.4, 45},
        DensityCase{SparsePattern::kGrid, 0.6, 0}, DensityCase{SparsePattern::kGrid, 0.6, 45},
        DensityCase{SparsePattern::kGrid, 0.8, 0}, DensityCase{SparsePattern::kGrid, 0.8, 45}));

TEST(Sparse, LinesOfAllRegionsLieOnOneGrid) {
  const SparseFill fill{.pattern = SparsePattern::kRectilinear};
  const double pitch = static_cast<double>(Spacing(450'000, 200'000)) / 0.2;
  for (const char* text : {"(0 0, 30 0, 30 30, 0 30)", "(41 7, 60 3, 77 31)"}) {
    const auto paths = FillSparse(P(text), fill);
    ASSERT_TRUE(paths.ok());
    for (const Path& path : *paths) {
      for (size_t i = 1; i < path.points.size(); ++i) {
        if (path.points[i].y != path.points[i - 1].y) continue;
        const double rows = static_cast<double>(path.points[i].y) / pitch - 0.25;
        EXPECT_NEAR(rows, std::round(rows), 1e-5);
      }
    }
  }
}

TEST(Sparse, BoxIsOnePath) {
  EXPECT_EQ(
      FillSparse(P("(0 0, 80 0, 80 80, 0 80)"), {.pattern = SparsePattern::kRectilinear})->size(),
      1u);
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
  const MultiPolygon grown = FastOffset(region, 1'000);
  for (const double angle : {0.0, 0.4, 0.8, 1.57}) {
    const auto paths =
        FillSparse(region, {.density = 0.3, .angle_rad = angle, .overlap_nm = 225'000});
    for (const Path& path : *paths)
      for (const Point p : path.points) EXPECT_EQ(Locate(p, grown[0]), Side::kInside) << ToText(p);
  }
}

}  // namespace
}  // namespace slicefarm::infill
