#include "processes/fdm/job/fdm_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace slicefarm::coordinator::fdm_report_test {
namespace {

nlohmann::ordered_json JsonOf(const FdmReport& report) {
  nlohmann::ordered_json json;
  report.AddTo(json);
  return json;
}

TEST(FdmReport, HasWhatIsOfFilament) {
  FdmReport report;
  report.file_name = "part.gcode";
  report.filament.mass_g = 2.98;
  report.stats.features[static_cast<int>(Feature::kGapFill)] = {1, 2, 3, 4};
  report.stats.retractions = 9;
  report.travel_mm = 77;
  report.seams = {10, 8, 2, 1.5, 0, 0, 1};
  const auto json = JsonOf(report);
  EXPECT_EQ(json["file_name"], "part.gcode");
  EXPECT_DOUBLE_EQ(json["filament"]["g"], 2.98);
  EXPECT_EQ(json["features"].size(), 1u);
  EXPECT_EQ(json["features"]["Gap fill"]["volume_mm3"], 4);
  EXPECT_EQ(json["travel"]["retractions"], 9);
  EXPECT_EQ(json["travel"]["length_mm"], 77);
  EXPECT_EQ(json["seams"]["loops"], 10);
  EXPECT_DOUBLE_EQ(json["seams"]["jumps_share"], 0.25);
  EXPECT_DOUBLE_EQ(json["seams"]["mean_step_mm"], 0.25);
  EXPECT_TRUE(json["seams"]["on_corner_share"].is_null()) << "no loop has a corner";
  EXPECT_DOUBLE_EQ(json["seams"]["overhanging_share"], 0.1);
}

TEST(FdmReport, SparseInfillHasADensityAndSolidCovers) {
  FdmReport report;
  report.fills = {{1, Feature::kInternalInfill, FillPattern::kGyroid, 100, 20, 4, 5, 7, 80, 30},
                  {2, Feature::kBridgeInfill, std::nullopt, 10, 2, 1, 1.5, 3, 8, 6}};
  const auto json = JsonOf(report)["infill"];
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[0]["settings"], 1);
  EXPECT_EQ(json[0]["feature"], "Internal infill");
  EXPECT_EQ(json[0]["pattern"], "gyroid");
  EXPECT_DOUBLE_EQ(json[0]["density_asked"], 0.2);
  EXPECT_DOUBLE_EQ(json[0]["density"], 0.25);
  EXPECT_EQ(json[0]["area_mm2"], 100);
  EXPECT_EQ(json[0]["volume_mm3"], 5);
  EXPECT_EQ(json[0]["paths"], 7);
  EXPECT_EQ(json[0]["length_mm"], 80);
  EXPECT_EQ(json[0]["longest_path_mm"], 30);
  EXPECT_TRUE(json[1]["pattern"].is_null());
  EXPECT_DOUBLE_EQ(json[1]["coverage_asked"], 0.5);
  EXPECT_DOUBLE_EQ(json[1]["coverage"], 0.75);
}

}  // namespace
}  // namespace slicefarm::coordinator::fdm_report_test
