#include "services/exposure/algo/scan/melted_sample.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/text_format_test.h"

namespace slicefarm::exposure::melted_sample_test {
namespace {

const char kSquare[] = "(0 0, 10 0, 10 10, 0 10)";

/// Returns lines along x at every `pitch` mm, beginning at `from_mm`.
ExposureGroup Lines(double pitch, double from_mm, bool upright) {
  ExposureGroup group;
  for (double v = from_mm; v < 10; v += pitch) {
    const Point a{FromMm(0), FromMm(v)}, b{FromMm(10), FromMm(v)};
    if (upright)
      group.AddLine(std::vector<Point>{{a.y, a.x}, {b.y, b.x}});
    else
      group.AddLine(std::vector<Point>{a, b});
  }
  return group;
}

MeltedSample Sample(const std::vector<ExposureGroup>& groups, const ExposureOptions& options = {},
                    const char* outline = kSquare) {
  MeltedSample sum;
  for (int32_t layer = 0; layer < 100; ++layer)
    sum.Add(SampleMelted(groups, MakePolygonsOrDie(outline), options, layer));
  return sum;
}

TEST(SampleMelted, LinesASpotApartMeltAllOnce) {
  for (const bool upright : {false, true}) {
    const MeltedSample sample = Sample({Lines(0.08, 0.04, upright)});
    EXPECT_NEAR(sample.length_mm, 3 * 100 * 10, 1e-6);
    EXPECT_NEAR(sample.Melted(), 1, 1e-6);
    // 200 W at 800 mm/s with a distance of 0.08 mm.
    EXPECT_NEAR(sample.MeanJmm2(), 200.0 / 800 / 0.08, 0.02);
    EXPECT_EQ(sample.pieces, 3 * 100 * 10);
  }
}

TEST(SampleMelted, HalfTheLinesMeltHalf) {
  for (const bool upright : {false, true}) {
    const MeltedSample sample = Sample({Lines(0.16, 0.04, upright)});
    EXPECT_NEAR(sample.Melted(), 0.5, 0.04);
    EXPECT_NEAR(sample.MeanJmm2(), 0.5 * 200 / 800 / 0.08, 0.15);
  }
}

TEST(SampleMelted, WhatIsMeltedTwiceIsTheMost) {
  ExposureOptions options;
  options.styles[static_cast<size_t>(ExposureKind::kContour)].power_w = 400;
  std::vector<ExposureGroup> groups = {Lines(0.08, 0.04, true), Lines(0.08, 5.04, true)};
  groups[1].kind = ExposureKind::kContour;
  const MeltedSample sample = Sample(groups, options);
  EXPECT_NEAR(sample.least_j_mm2, 3.125, 0.01);
  EXPECT_NEAR(sample.most_j_mm2, 3 * 3.125, 0.15);
}

TEST(SampleMelted, SlopingLinesHolesAndNothing) {
  ExposureGroup slope;
  slope.AddLine(std::vector<Point>{{FromMm(0), FromMm(0)}, {FromMm(10), FromMm(10)}});
  ExposureOptions options;
  options.spot_nm = FromMm(1);
  // A band of 1 mm from corner to corner: the square without two triangles.
  EXPECT_NEAR(Sample({slope}, options).melted_mm / 300, (100 - 9.293 * 9.293) / 10, 0.01);
  EXPECT_NEAR(Sample({slope}, options, "(0 0, 10 0, 10 10, 0 10) (1 1, 1 9, 9 9, 9 1)").length_mm,
              300 * (0.2 * 10 + 0.8 * 2), 10);
  EXPECT_EQ(Sample({}).melted_mm, 0);
  EXPECT_EQ(Sample({}).Melted(), 0);
  EXPECT_EQ(SampleMelted({}, {}, {}, 0), MeltedSample{});
}

}  // namespace
}  // namespace slicefarm::exposure::melted_sample_test
