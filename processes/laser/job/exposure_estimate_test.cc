#include "processes/laser/job/exposure_estimate.h"

#include <gtest/gtest.h>

#include <vector>

#include "common/geometry/text_format_test.h"
#include "processes/laser/model/exposure_options.h"
#include "processes/laser/model/exposure_settings.h"

namespace slicefarm::coordinator::exposure_estimate_test {
namespace {

// A square of 10 mm has 1,000 mm of hatch at a distance of 0.1 mm, and two contours of 80 mm in
// total.
TEST(EstimateExposure, IsAreaByHatchAndPerimeterByContours) {
  ExposureSettings settings;
  settings.regions[0].hatch_distance_nm = FromMm(0.1);
  settings.regions[0].contours = 2;
  for (ExposureStyle& style : settings.regions[0].styles) style.speed_mm_s = 1000;
  SlicedLayer layer;
  layer.sections.emplace_back().regions.push_back(
      {.outlines = MakePolygonsOrDie("(0 0, 10 0, 10 10, 0 10)")});
  const std::vector<SlicedLayer> layers(3, layer);
  const std::vector<PlacedCopy> copies(2);
  const JobEstimate estimate = EstimateExposure({layers, copies}, settings);
  EXPECT_NEAR(estimate.print_time_s, 3 * 2 * 1.08, 1e-9);
  EXPECT_EQ(EstimateExposure({}, settings).print_time_s, 0);
  settings.output.recoat_s = 8;
  EXPECT_NEAR(EstimateExposure({layers, copies}, settings).print_time_s, 3 * 8 + 3 * 2 * 1.08,
              1e-9);
}

}  // namespace
}  // namespace slicefarm::coordinator::exposure_estimate_test
