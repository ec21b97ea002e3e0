#include "services/exposure/algo/exposure_report.h"

#include <gtest/gtest.h>

namespace slicefarm::exposure::exposure_report_test {
namespace {

ExposedLayer TwoLines() {
  ExposedLayer layer;
  layer.frame = {3, 200'000, 50'000};
  ExposureGroup hatch;
  hatch.points = {{0, 0}, {10'000'000, 0}, {10'000'000, 1'000'000}, {0, 1'000'000}};
  ExposureGroup contour;
  contour.kind = ExposureKind::kContour;
  contour.AddLine(Polyline{{0, 0}, {3'000'000, 0}, {3'000'000, 4'000'000}, {0, 0}});
  layer.groups = {hatch, contour};
  layer.visits = {{.object = 0, .copy = 0, .shift = {}}};
  layer.area_mm2 = 10;
  return layer;
}

constexpr size_t kHatch = static_cast<size_t>(ExposureKind::kHatch);
constexpr size_t kContour = static_cast<size_t>(ExposureKind::kContour);

TEST(ReportOf, LengthsTimesAndEnergyByHand) {
  ExposureOptions options;
  options.styles[kHatch] = {.power_w = 100, .speed_mm_s = 1000};
  options.styles[kContour] = {.power_w = 50, .speed_mm_s = 500};
  options.jump = {.speed_mm_s = 2000, .delay_us = 100, .mark_delay_us = 50, .polygon_delay_us = 10};
  const ExposureReport report = ReportOf(TwoLines(), std::vector{options});
  EXPECT_EQ(report.kinds[kHatch].vectors, 2);
  EXPECT_EQ(report.kinds[kHatch].lines, 2);
  EXPECT_DOUBLE_EQ(report.kinds[kHatch].length_mm, 20);
  EXPECT_DOUBLE_EQ(report.kinds[kHatch].time_s, 20.0 / 1000 + 2 * 50e-6);
  EXPECT_DOUBLE_EQ(report.kinds[kHatch].energy_j, 100 * 20.0 / 1000);
  EXPECT_EQ(report.kinds[kContour].vectors, 3);
  EXPECT_DOUBLE_EQ(report.kinds[kContour].length_mm, 12);
  EXPECT_DOUBLE_EQ(report.kinds[kContour].time_s, 12.0 / 500 + 50e-6 + 2 * 10e-6);
  EXPECT_EQ(report.jumps, 2);  // between the lines, and to the contour
  EXPECT_DOUBLE_EQ(report.jump_mm, 2);
  EXPECT_DOUBLE_EQ(report.jump_time_s, 2.0 / 2000 + 2 * 100e-6);
  EXPECT_DOUBLE_EQ(report.volume_mm3, 0.5);
  EXPECT_DOUBLE_EQ(report.EnergyDensityJmm3(), (2 + 50 * 12.0 / 500) / 0.5);
  EXPECT_EQ(report.bounds, (Box{{0, 0}, {10'000'000, 4'000'000}}));
  EXPECT_DOUBLE_EQ(report.TimeS(), report.kinds[kHatch].time_s + report.kinds[kContour].time_s +
                                       report.jump_time_s);
}

TEST(ReportOf, PulsesReplaceTheSpeed) {
  ExposureOptions options;
  options.styles[kHatch] = {
      .power_w = 100, .point_distance_nm = 100'000, .point_time_us = 20, .point_delay_us = 5};
  const ExposureReport report = ReportOf(TwoLines(), std::vector{options});
  EXPECT_NEAR(report.kinds[kHatch].time_s, 2 * 101 * 25e-6, 1e-12);
  EXPECT_NEAR(report.kinds[kHatch].energy_j, 2 * 101 * 20e-6 * 100, 1e-9);
}

TEST(ReportOf, SkywritingIsWayWithoutExposure) {
  ExposureOptions options;
  options.styles[kHatch].speed_mm_s = 1000;
  options.jump.mark_delay_us = 50;
  ExposedLayer layer = TwoLines();
  layer.groups.pop_back();
  const ExposureReport plain = ReportOf(layer, std::vector{options});
  layer.groups[0].run_nm = 500'000;
  const ExposureReport report = ReportOf(layer, std::vector{options});
  EXPECT_DOUBLE_EQ(report.kinds[kHatch].length_mm, plain.kinds[kHatch].length_mm);
  EXPECT_DOUBLE_EQ(report.kinds[kHatch].time_s, 20.0 / 1000);  // no mark delay
  EXPECT_DOUBLE_EQ(report.jump_mm, plain.jump_mm + 4 * 0.5);   // both runs are on the same side
}

TEST(ReportOf, CopiesCountAndReportsAddUp) {
  const std::vector<ExposureOptions> regions(1);
  ExposedLayer layer = TwoLines();
  ExposureReport once = ReportOf(layer, regions);
  layer.visits.push_back({.object = 0, .copy = 1, .shift = {100'000'000, 0}});
  const ExposureReport twice = ReportOf(layer, regions);
  EXPECT_EQ(twice.Total().vectors, 2 * once.Total().vectors);
  EXPECT_EQ(twice.jumps, 2 * once.jumps + 1);
  EXPECT_EQ(twice.bounds.max.x, 110'000'000);
  const double energy = once.Total().energy_j;
  once.Add(ReportOf(TwoLines(), regions));
  EXPECT_DOUBLE_EQ(once.Total().energy_j, 2 * energy);
  EXPECT_EQ(once.jumps, 4);
}

}  // namespace
}  // namespace slicefarm::exposure::exposure_report_test
