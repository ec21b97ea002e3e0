#include "services/milling/algo/strategy/free_area.h"

#include <gtest/gtest.h>

#include "common/geometry/measure.h"
#include "services/milling/algo/sample_jobs_test.h"

namespace slicefarm::milling::free_area_test {
namespace {

double AreaMm2(const MultiPolygon& region) { return Area(region) / 1e12; }

std::vector<FreeArea> AreasOf(const MillingJob& job, double allowance,
                              const std::vector<double>& levels) {
  auto areas = FreeAreas(job, allowance, levels, {});
  EXPECT_TRUE(areas.ok()) << areas.status();
  return *std::move(areas);
}

/// The cutter is a cylinder of 1 mm around a block of 9 x 8 mm in stock 1 mm wider. The results are
/// rounded boxes with known areas.
TEST(FreeAreas, AreThoseOfGeometry) {
  const Pillars block{.heights = {{2}}, .side = 8};
  MillingOptions options = OptionsFor("cyl:1");
  options.tolerance_mm = 0.002;
  options.sampling_mm = 0.1;
  const MillingJob job = JobOf(block.Mesh(), options);
  const auto rounded = [](double side, double by) {
    return side * side + 4 * side * by + std::numbers::pi * by * by;
  };
  const double reach = rounded(10, 0.5 + options.machining.clearance_mm);
  for (const double allowance : {0.0, 0.3}) {
    const std::vector<FreeArea> areas = AreasOf(job, allowance, {2.5, 1});
    EXPECT_NEAR(AreaMm2(areas[0].reach), reach, 0.05);
    EXPECT_NEAR(AreaMm2(areas[0].free), reach, 0.05);
    EXPECT_NEAR(AreaMm2(areas[1].free), reach - rounded(8, 0.5 + allowance), 0.05) << allowance;
    ASSERT_EQ(areas[1].free.size(), 1u);
    EXPECT_EQ(areas[1].free[0].holes.size(), 1u);
  }
}

/// A flat is free on its own level. On its allowance level, the cutter keeps the allowance to the
/// part.
TEST(FreeAreas, PassOverFlats) {
  const MillingJob job = JobOf(PocketPart().Mesh(), OptionsFor("cyl:1"));
  for (const double allowance : {0.0, 0.2}) {
    const std::vector<FreeArea> areas =
        AreasOf(job, allowance, {3 + allowance, 3 + allowance - 1e-5});
    EXPECT_NEAR(AreaMm2(areas[0].free), AreaMm2(areas[0].reach), 1e-6);
    EXPECT_LT(AreaMm2(areas[1].free), AreaMm2(areas[1].reach) - 20);
  }
}

TEST(FreeAreas, ShrinkDownwards) {
  for (const std::string_view text : {"cyl:1", "ball:1", "bull:1:0.2", "cone:1:30"}) {
    const MillingJob job = JobOf(PocketPart().Mesh(), OptionsFor(text));
    const std::vector<FreeArea> areas = AreasOf(job, 0.1, {3.5, 2.9, 2.2, 1.5, 0.9, 0});
    for (size_t i = 1; i < areas.size(); ++i)
      EXPECT_LE(AreaMm2(areas[i].free), AreaMm2(areas[i - 1].free) + 0.02) << text << i;
  }
}

}  // namespace
}  // namespace slicefarm::milling::free_area_test
