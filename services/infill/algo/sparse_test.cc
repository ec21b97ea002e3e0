#include "services/infill/algo/sparse.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/text_format_test.h"
#include "common/model/bead_section.h"

namespace slicefarm::infill::sparse_test {
namespace {

MultiPolygon P(std::string_view text) { return MakePolygonsOrDie(text); }

/// Returns a fill with the default links of other slicers.
SparseFill Linked(FillPattern pattern) {
  return {.pattern = pattern,
          .overlap_nm = 112'500,
          .anchor_nm = 2'700'000,
          .anchor_max_nm = 50'000'000};
}

TEST(Sparse, LinesOfAllRegionsLieOnOneGrid) {
  const SparseFill fill{.pattern = FillPattern::kRectilinear};
  const double pitch = static_cast<double>(Spacing(450'000, 200'000)) / 0.2;
  for (const char* text : {"(0 0, 30 0, 30 30, 0 30)", "(41 7, 60 3, 77 31)"}) {
    const auto paths = FillSparse(P(text), fill);
    ASSERT_TRUE(paths.ok());
    for (const Path& path : *paths) {
      const double rows = static_cast<double>(path.points[0].y) / pitch;
      EXPECT_EQ(path.points[0].y, path.points[1].y);
      EXPECT_NEAR(rows, std::round(rows), 1e-5);
    }
  }
}

TEST(Sparse, AConvexRegionIsOnePath) {
  for (const FillPattern pattern :
       {FillPattern::kRectilinear, FillPattern::kZigzag, FillPattern::kArchimedean})
    for (const char* text : {"(0 0, 80 0, 80 80, 0 80)", "(3 5, 60 0, 90 44, 20 70)"})
      EXPECT_EQ(FillSparse(P(text), Linked(pattern))->size(), 1u)
          << InfoOf(pattern).name << ' ' << text;
}

// This is true at most heights. Where waves run along a side, the side cuts off their crests, and
// crests behind crests are a dead end. A path has two ends, so that three such positions need two
// paths. At some heights, the crests of all waves are so near to a side that a link beside them
// would overlap them.
TEST(Sparse, GyroidThroughASquareIsOnePath) {
  SparseFill fill = Linked(FillPattern::kGyroid);
  fill.angle_rad = std::numbers::pi / 4;
  int layers = 0, parted = 0;
  for (fill.z_nm = 100'000; fill.z_nm < 6'000'000; fill.z_nm += 200'000, ++layers)
    if (FillSparse(P("(0 0, 80 0, 80 80, 0 80)"), fill)->size() > 1) ++parted;
  EXPECT_LE(parted, layers * 2 / 5);
}

// One short line crosses a corner of a region, at all positions of the lines: the path there holds
// to the edge, or is omitted.
TEST(Sparse, NoLoneDots) {
  for (Coord x = 0; x < 3'000'000; x += 100'000) {
    const MultiPolygon pocket = {{{{x, 0}, {x + 1'300'000, 0}, {x, 1'300'000}}, {}}};
    const auto paths = FillSparse(pocket, Linked(FillPattern::kGrid));
    ASSERT_TRUE(paths.ok());
    for (const Path& path : *paths) EXPECT_GE(PathLength(path), 2.5 * 450'000) << x;
  }
}

// A neck of 0.4 mm has no space for lines that do not overlap, even beside an island that is wide
// everywhere; a neck of 0.6 mm has.
TEST(Sparse, NarrowPlacesStayEmpty) {
  const auto two_squares = [](double neck_mm) {
    const auto mm = [](double x, double y) { return Point{FromMm(x), FromMm(y)}; };
    const double low = 10 - neck_mm / 2, high = 10 + neck_mm / 2;
    return MultiPolygon{
        {{mm(0, 0), mm(20, 0), mm(20, low), mm(30, low), mm(30, 0), mm(50, 0), mm(50, 20),
          mm(30, 20), mm(30, high), mm(20, high), mm(20, 20), mm(0, 20)},
         {}}};
  };
  const auto neck_mm = [](const MultiPolygon& region) {
    double length = 0;
    const auto paths = FillSparse(region, Linked(FillPattern::kGrid));
    for (const Path& path : *paths)
      for (size_t i = 1; i < path.points.size(); ++i) {
        const Point a = path.points[i - 1], b = path.points[i];
        if (std::min(a.x, b.x) > FromMm(21) && std::max(a.x, b.x) < FromMm(29))
          length += ToMm(Distance(a, b));
      }
    return length;
  };
  EXPECT_EQ(neck_mm(two_squares(0.4)), 0);
  EXPECT_GT(neck_mm(two_squares(0.6)), 5);
  MultiPolygon both = two_squares(0.4);
  both.push_back(P("(60 0, 90 0, 90 25, 60 30)")[0]);
  EXPECT_EQ(neck_mm(both), 0);
}

TEST(Sparse, NothingIsLinkedIfNoLinkIsAllowed) {
  SparseFill fill = Linked(FillPattern::kRectilinear);
  fill.anchor_max_nm = 0;
  const auto paths = FillSparse(P("(0 0, 80 0, 80 80, 0 80)"), fill);
  for (const Path& path : *paths) EXPECT_EQ(path.points.size(), 2u);
  EXPECT_GT(paths->size(), 30u);
}

TEST(Sparse, RectilinearTurnsWithTheLayer) {
  const MultiPolygon box = P("(0 0, 30 0, 30 30, 0 30)");
  SparseFill fill{.pattern = FillPattern::kRectilinear};
  const auto even = FillSparse(box, fill);
  fill.layer = 1;
  const auto odd = FillSparse(box, fill);
  EXPECT_EQ((*even)[0].points[0].y, (*even)[0].points[1].y);
  EXPECT_EQ((*odd)[0].points[0].x, (*odd)[0].points[1].x);
}

TEST(Sparse, NothingAtNoDensityAndInNothing) {
  EXPECT_TRUE(FillSparse(P("(0 0, 30 0, 30 30, 0 30)"), {.density = 0})->empty());
  EXPECT_TRUE(FillSparse({}, {})->empty());
}

}  // namespace
}  // namespace slicefarm::infill::sparse_test
