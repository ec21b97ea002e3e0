#include "services/coordinator/algo/pipeline/report_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace slicefarm::coordinator::report_json_test {
namespace {

struct Own : ProcessReport {
  void AddTo(nlohmann::ordered_json& json) const override { json["own"] = 7; }
};

TEST(ReportJson, HasWhatTheReportHas) {
  JobReport report;
  report.meshes = {{.name = "cube.stl", .triangles = 12, .open_edges = 3}};
  report.layer_count = 50;
  report.object_height_mm = 10;
  report.print_time_s = 3723.4;
  report.own = std::make_unique<Own>();
  report.stage_times[Stage::kPlanning] = 0.25;
  report.stage_times[Stage::kInfill] = 0.5;
  report.warnings = {"careful"};

  const auto json = nlohmann::json::parse(ReportJson(
      report,
      {.settings_without_effect = {"raft_layers"}, .settings_digest = "d", .build_id = "b"}));
  EXPECT_EQ(json["meshes"][0]["triangles"], 12);
  EXPECT_EQ(json["meshes"][0]["closed"], false);
  EXPECT_EQ(json["layers"], 50);
  EXPECT_EQ(json["print_time"], "1h 2m 3s");
  EXPECT_DOUBLE_EQ(json["print_time_s"], 3723.4);
  EXPECT_DOUBLE_EQ(json["stage_times_s"]["planning"], 0.25);
  EXPECT_DOUBLE_EQ(json["stage_times_s"]["infill"], 0.5);
  EXPECT_EQ(json["stage_times_s"].size(), kStageCount);
  EXPECT_EQ(json["own"], 7);
  EXPECT_EQ(json["warnings"][0], "careful");
  EXPECT_EQ(json["settings_without_effect"][0], "raft_layers");
  EXPECT_EQ(json["settings_digest"], "d");
  EXPECT_EQ(json["build_id"], "b");
}

TEST(ReportJson, HasTheSharesOfObjects) {
  JobReport report;
  report.shares = {{{"a", {{1, {2, 3, 4, 5}}, {10, {20, 30, 40, 50}}}}}, {7, {8, 9, 10, 11}}};
  const auto json = nlohmann::json::parse(ReportJson(report, {}));
  ASSERT_EQ(json["objects"].size(), 1u);
  EXPECT_EQ(json["objects"][0]["name"], "a");
  EXPECT_EQ(json["objects"][0]["time_s"], 11);
  EXPECT_EQ(json["objects"][0]["filament"]["g"], 44);
  EXPECT_EQ(json["objects"][0]["copies"][1]["filament"]["mm"], 20);
  EXPECT_EQ(json["shared"]["filament"]["cost"], 11);
  EXPECT_FALSE(nlohmann::json::parse(ReportJson({}, {})).contains("objects"));
}

TEST(ReportJson, HasTheValuesOfACalibrationPrint) {
  const CalibrationTable table = {
      "flow", "%", "extrusion_multiplier", {{"+5", 1.05, 0, 0, "p"}, {"2", 3, 4, 5, "q"}}};
  const auto json = nlohmann::json::parse(ReportJson({}, {.calibration = table}))["calibration"];
  EXPECT_EQ(json["kind"], "flow");
  EXPECT_EQ(json["setting"], "extrusion_multiplier");
  ASSERT_EQ(json["values"].size(), 2u);
  EXPECT_EQ(json["values"][0]["label"], "+5");
  EXPECT_EQ(json["values"][0]["value"], 1.05);
  EXPECT_FALSE(json["values"][0].contains("from_mm"));
  EXPECT_EQ(json["values"][1]["to_mm"], 5);
  EXPECT_FALSE(nlohmann::json::parse(ReportJson({}, {})).contains("calibration"));
}

TEST(ReportJson, SurvivesNamesThatAreNoText) {
  JobReport report;
  report.meshes = {{.name = "\xff\xfe\"\n"}};
  EXPECT_TRUE(nlohmann::json::accept(ReportJson(report, {})));
}

}  // namespace
}  // namespace slicefarm::coordinator::report_json_test
