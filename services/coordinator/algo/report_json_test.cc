#include "services/coordinator/algo/report_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace slicefarm::coordinator {
namespace {

TEST(ReportJson, HasWhatTheReportHas) {
  JobReport report;
  report.meshes = {{.name = "cube.stl", .triangles = 12, .open_edges = 3}};
  report.layer_count = 50;
  report.object_height_mm = 10;
  report.print_time_s = 3723.4;
  report.travel_mm = 77;
  report.filament_mm = 1000;
  report.filament_g = 2.98;
  report.filament_cost = 0.06;
  report.stage_times.infill_s = 0.5;
  report.stats.features[static_cast<int>(Feature::kGapFill)] = {1, 2, 3, 4};
  report.stats.retractions = 9;
  report.warnings = {"careful"};

  const auto json = nlohmann::json::parse(ReportJson(
      report,
      {.settings_without_effect = {"raft_layers"}, .settings_digest = "d", .build_id = "b"}));
  EXPECT_EQ(json["meshes"][0]["triangles"], 12);
  EXPECT_EQ(json["meshes"][0]["closed"], false);
  EXPECT_EQ(json["layers"], 50);
  EXPECT_EQ(json["print_time"], "1h 2m 3s");
  EXPECT_DOUBLE_EQ(json["print_time_s"], 3723.4);
  EXPECT_DOUBLE_EQ(json["filament"]["g"], 2.98);
  EXPECT_DOUBLE_EQ(json["stage_times_s"]["infill"], 0.5);
  EXPECT_EQ(json["features"].size(), 1u);
  EXPECT_EQ(json["features"]["Gap fill"]["volume_mm3"], 4);
  EXPECT_EQ(json["travel"]["retractions"], 9);
  EXPECT_EQ(json["warnings"][0], "careful");
  EXPECT_EQ(json["settings_without_effect"][0], "raft_layers");
  EXPECT_EQ(json["settings_digest"], "d");
  EXPECT_EQ(json["build_id"], "b");
}

TEST(ReportJson, SurvivesNamesThatAreNoText) {
  JobReport report;
  report.meshes = {{.name = "\xff\xfe\"\n"}};
  EXPECT_TRUE(nlohmann::json::accept(ReportJson(report, {})));
}

TEST(DurationText, ShowsWhatIsNeeded) {
  EXPECT_EQ(DurationText(0), "0s");
  EXPECT_EQ(DurationText(59.9), "59s");
  EXPECT_EQ(DurationText(60), "1m 0s");
  EXPECT_EQ(DurationText(86400 + 5), "1d 0h 0m 5s");
  EXPECT_EQ(DurationText(-3), "0s");
}

}  // namespace
}  // namespace slicefarm::coordinator
