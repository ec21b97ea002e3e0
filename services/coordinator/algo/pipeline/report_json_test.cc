#include "services/coordinator/algo/pipeline/report_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace slicefarm::coordinator::report_json_test {
namespace {

TEST(ReportJson, HasWhatTheReportHas) {
  JobReport report;
  report.meshes = {{.name = "cube.stl", .triangles = 12, .open_edges = 3}};
  report.layer_count = 50;
  report.object_height_mm = 10;
  report.print_time_s = 3723.4;
  report.travel_mm = 77;
  report.filament.length_mm = 1000;
  report.filament.mass_g = 2.98;
  report.filament.cost = 0.06;
  report.stage_times.planning_s = 0.25;
  report.stage_times.infill_s = 0.5;
  report.stats.features[static_cast<int>(Feature::kGapFill)] = {1, 2, 3, 4};
  report.stats.retractions = 9;
  report.warnings = {"careful"};
  report.seams = {10, 8, 2, 1.5, 0, 0, 1};

  const auto json = nlohmann::json::parse(ReportJson(
      report,
      {.settings_without_effect = {"raft_layers"}, .settings_digest = "d", .build_id = "b"}));
  EXPECT_EQ(json["meshes"][0]["triangles"], 12);
  EXPECT_EQ(json["meshes"][0]["closed"], false);
  EXPECT_EQ(json["layers"], 50);
  EXPECT_EQ(json["print_time"], "1h 2m 3s");
  EXPECT_DOUBLE_EQ(json["print_time_s"], 3723.4);
  EXPECT_DOUBLE_EQ(json["filament"]["g"], 2.98);
  EXPECT_DOUBLE_EQ(json["stage_times_s"]["planning"], 0.25);
  EXPECT_DOUBLE_EQ(json["stage_times_s"]["infill"], 0.5);
  EXPECT_EQ(json["features"].size(), 1u);
  EXPECT_EQ(json["features"]["Gap fill"]["volume_mm3"], 4);
  EXPECT_EQ(json["travel"]["retractions"], 9);
  EXPECT_EQ(json["warnings"][0], "careful");
  EXPECT_EQ(json["seams"]["loops"], 10);
  EXPECT_DOUBLE_EQ(json["seams"]["jumps_share"], 0.25);
  EXPECT_DOUBLE_EQ(json["seams"]["mean_step_mm"], 0.25);
  EXPECT_TRUE(json["seams"]["on_corner_share"].is_null()) << "no loop has a corner";
  EXPECT_DOUBLE_EQ(json["seams"]["overhanging_share"], 0.1);
  EXPECT_EQ(json["settings_without_effect"][0], "raft_layers");
  EXPECT_EQ(json["settings_digest"], "d");
  EXPECT_EQ(json["build_id"], "b");
}

TEST(ReportJson, SparseInfillHasADensityAndSolidCovers) {
  JobReport report;
  report.fills = {{1, Feature::kInternalInfill, FillPattern::kGyroid, 100, 20, 4, 5, 7, 80, 30},
                  {2, Feature::kBridgeInfill, std::nullopt, 10, 2, 1, 1.5, 3, 8, 6}};
  const auto json = nlohmann::json::parse(ReportJson(report, {}))["infill"];
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

TEST(ReportJson, SurvivesNamesThatAreNoText) {
  JobReport report;
  report.meshes = {{.name = "\xff\xfe\"\n"}};
  EXPECT_TRUE(nlohmann::json::accept(ReportJson(report, {})));
}

}  // namespace
}  // namespace slicefarm::coordinator::report_json_test
