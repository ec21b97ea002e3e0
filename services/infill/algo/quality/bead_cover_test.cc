#include "services/infill/algo/quality/bead_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/geometry/boolean/random_islands_test.h"
#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"
#include "common/model/options/fill_patterns.h"
#include "services/infill/algo/solid.h"
#include "services/infill/algo/sparse.h"

namespace slicefarm::infill::bead_cover_test {
namespace {

constexpr Coord kFlat = 1;  ///< height at which beads have straight sides

Path LineOf(std::initializer_list<Point> mm) {
  Path path;
  for (const Point p : mm) path.points.push_back({p.x * kNmPerMm, p.y * kNmPerMm});
  path.widths_nm = {kNmPerMm};
  return path;
}

/// Returns the share of the region's pixels of `px` that are on a bead, tested at one point per
/// pixel. It shares no code with the tested function: it compares the distance to the nearest point
/// of each edge with half of the width there.
double RasterCovered(const MultiPolygon& region, std::span<const Path> paths, Coord px) {
  const Box box = Bounds(region);
  const Coord columns = (box.max.x - box.min.x) / px, rows = (box.max.y - box.min.y) / px;
  std::vector<char> beads(static_cast<size_t>(columns * rows));
  // The points are not in rows and columns, because a line along them would meet all points of a
  // row.
  const auto middle = [&](Coord x, Coord y) {
    return Point{box.min.x + x * px + y * 1'618 % px, box.min.y + y * px + x * 2'718 % px};
  };
  for (const Path& path : paths) {
    const size_t edges = path.points.size() - (path.closed ? 0 : 1);
    for (size_t i = 0; i < edges; ++i) {
      const size_t j = (i + 1) % path.points.size();
      const Point a = path.points[i], route = path.points[j] - a;
      const auto ra = static_cast<double>(path.WidthAt(i)) / 2,
                 rb = static_cast<double>(path.WidthAt(j)) / 2;
      const auto wide = static_cast<Coord>(std::max(ra, rb)) + px;
      const auto index = [&](Coord at, Coord min, Coord count) {
        return std::clamp<Coord>((at - min) / px, 0, count - 1);
      };
      const Point b = a + route;
      for (Coord y = index(std::min(a.y, b.y) - wide, box.min.y, rows);
           y <= index(std::max(a.y, b.y) + wide, box.min.y, rows); ++y) {
        for (Coord x = index(std::min(a.x, b.x) - wide, box.min.x, columns);
             x <= index(std::max(a.x, b.x) + wide, box.min.x, columns); ++x) {
          const Point p = middle(x, y) - a;
          const double square = SquaredNorm(route);
          const double along = static_cast<double>(p.x) * static_cast<double>(route.x) +
                               static_cast<double>(p.y) * static_cast<double>(route.y);
          const double t = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
          const double away =
              std::hypot(static_cast<double>(p.x) - t * static_cast<double>(route.x),
                         static_cast<double>(p.y) - t * static_cast<double>(route.y));
          if (away <= ra + t * (rb - ra)) beads[static_cast<size_t>(y * columns + x)] = 1;
        }
      }
    }
  }
  double inside = 0, covered = 0;
  for (Coord y = 0; y < rows; ++y) {
    for (Coord x = 0; x < columns; ++x) {
      if (!Inside(middle(x, y), region)) continue;
      inside += 1;
      covered += beads[static_cast<size_t>(y * columns + x)];
    }
  }
  return covered / inside;
}

TEST(CoveredShare, IsAsWideAsBeadsAreAtEachPlace) {
  const MultiPolygon region = MakePolygonsOrDie("(0 0, 20 0, 20 10, 0 10)");
  Path steps = LineOf({{1, 2}, {8, 2}, {8, 2}, {15, 2}});
  steps.widths_nm = {kNmPerMm, kNmPerMm, kNmPerMm / 2, kNmPerMm / 2};
  Path widens = LineOf({{2, 6}, {12, 6}, {16, 9}, {18, 4}});
  widens.widths_nm = {kNmPerMm / 4, 2 * kNmPerMm, kNmPerMm, kNmPerMm};
  Path ring = LineOf({{3, 4}, {6, 4}, {6, 9}, {3, 9}});
  ring.closed = true;
  for (const std::vector<Path>& paths : {std::vector{steps}, std::vector{widens}, std::vector{ring},
                                         std::vector{steps, widens, ring}})
    EXPECT_NEAR(CoveredShare(region, paths, kFlat, kNmPerMm), RasterCovered(region, paths, 20'000),
                1e-3);
  // Two straight parts, half a disc at either end, and the part of the wider end's disc beside the
  // narrower part.
  const double discs = std::numbers::pi * (0.25 + 0.0625) / 2;
  const double beside = std::numbers::pi / 8 - 0.25 * std::sqrt(3.0) / 4 - std::numbers::pi / 24;
  EXPECT_NEAR(CoveredShare(region, std::vector{steps}, kFlat, kNmPerMm) * 200,
              7 + 3.5 + discs + beside, 0.01);
}

// The test covers every pattern, sparse and dense, in a region with a hole and a narrow part.
TEST(CoveredShare, IsWhatARasterFinds) {
  const MultiPolygon region =
      MakePolygonsOrDie("(0 0, 24 0, 24 9, 20 10, 24 11, 24 20, 0 20) (5 6, 5 14, 11 14, 11 6)");
  int looked_at = 0;
  for (const FillPatternInfo& info : kFillPatterns) {
    if (info.planned) continue;
    for (const double density : {0.15, 0.6}) {
      const auto paths = FillSparse(region, {.pattern = info.pattern,
                                             .density = density,
                                             .z_nm = 3 * kNmPerMm,
                                             .height_nm = kFlat,
                                             .anchor_nm = 3 * kNmPerMm,
                                             .anchor_max_nm = 50 * kNmPerMm});
      ASSERT_TRUE(paths.ok()) << info.name;
      EXPECT_NEAR(CoveredShare(region, *paths, kFlat, 450'000),
                  RasterCovered(region, *paths, 40'000), 2e-3)
          << info.name << " " << density;
      ++looked_at;
    }
    if (info.solid == SolidFillStyle::kNone) continue;
    const auto solid = FillSolid(region[0], {.pattern = info.pattern, .height_nm = kFlat});
    ASSERT_TRUE(solid.ok()) << info.name;
    EXPECT_NEAR(CoveredShare(region, solid->paths, kFlat, 450'000),
                RasterCovered(region, solid->paths, 40'000), 2e-3)
        << info.name << " solid";
  }
  EXPECT_GT(looked_at, 30);
}

}  // namespace
}  // namespace slicefarm::infill::bead_cover_test
