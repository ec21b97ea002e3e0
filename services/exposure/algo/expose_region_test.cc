#include "services/exposure/algo/expose_region.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::expose_region_test {
namespace {

TEST(ExposeRegion, GroupsSayWhoseTheyAre) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 4 0, 4 4, 0 4)");
  ExposureOptions options;
  options.skywriting_nm = 200'000;
  options.contour_run_nm = 300'000;
  CutCounts counts;
  const auto groups = ExposeRegion({.outlines = square,
                                    .section = square,
                                    .neighbours = {},
                                    .layer = 3,
                                    .object = 7,
                                    .settings = 2},
                                   options, {}, {}, counts);
  ASSERT_TRUE(groups.ok());
  ASSERT_EQ(groups->size(), 3u);  // contours, hatch lines along them, hatch
  for (const ExposureGroup& group : *groups) {
    EXPECT_EQ(group.object, 7);
    EXPECT_EQ(group.settings, 2);
    const bool is_contour = group.kind == ExposureKind::kContour;
    EXPECT_EQ(group.run_nm, is_contour ? 300'000 : group.IsHatch() ? 200'000 : 0);
  }
}

TEST(ExposeRegion, HatchKeepsItsOffsetFromTheLastContour) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 4 0, 4 4, 0 4)");
  ExposureOptions options;
  options.strategy = ScanStrategy::kHatch;
  options.hatch_angle_deg = 0;
  for (const int32_t contours : {0, 1, 3}) {
    options.contours = contours;
    CutCounts counts;
    const auto groups = ExposeRegion({.outlines = square, .section = square, .neighbours = {}},
                                     options, {}, {}, counts);
    ASSERT_TRUE(groups.ok());
    EXPECT_EQ(Bounds(groups->back().points).min.x, contours == 0 ? 40'000 : 80'000 * contours);
  }
}

TEST(ExposeRegion, RingsKeepItToo) {
  const MultiPolygon square = MakePolygonsOrDie("(0 0, 4 0, 4 4, 0 4)");
  ExposureOptions options;
  options.strategy = ScanStrategy::kRings;
  CutCounts counts;
  const auto groups = ExposeRegion({.outlines = square, .section = square, .neighbours = {}},
                                   options, {}, {}, counts);
  ASSERT_TRUE(groups.ok());
  // Contours are at 40 and 120 um, the outermost ring 80 um further inside.
  EXPECT_EQ(Bounds(groups->back().points).min.x, 200'000);
  EXPECT_EQ(counts.pieces, 1);
}

}  // namespace
}  // namespace slicefarm::exposure::expose_region_test
