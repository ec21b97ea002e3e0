#include "processes/engrave/model/engrave_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace slicefarm::engrave_report_test {
namespace {

TEST(ProgramFacts, AreAddedUp) {
  ProgramFacts sum{.seconds = 1, .moves = 2, .least_deg = {-1, 0}, .most_deg = {0, 5}};
  sum.Add({.seconds = 2, .filament_mm = 4, .moves = 3, .least_deg = {0, -9}, .most_deg = {7, 1}});
  EXPECT_EQ(sum, (ProgramFacts{3, 4, 5, {-1, -9}, {7, 5}}));
}

TEST(Warnings, TellOfFoldsAndOfNothing) {
  const MapReport map{.line_distance_mm = {1, 1, 1}};
  LayerNumbers layer{.layer = 4, .folds = 3, .folds_mm = 0.5, .first_fold_mm = {1, 2, 3}};
  const auto warnings = WarningsOf(map, {layer});
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_THAT(warnings[0], testing::HasSubstr("layer 4, at (1.000, 2.000, 3.000)"));
  EXPECT_THAT(warnings[1], testing::HasSubstr("no line"));
}

TEST(JsonOf, SumsUpLayers) {
  EngraveReport report;
  report.layers = {{.layer = 0, .on_mm = 2}, {.layer = 1, .on_mm = 3, .folds = 1}};
  const auto json = JsonOf(report);
  EXPECT_EQ(json["on_mm"], 5);
  EXPECT_EQ(json["layer_count"], 2);
  EXPECT_FALSE(json["layers"][0].contains("folds"));
  EXPECT_EQ(json["layers"][1]["folds"]["places"], 1);
  EXPECT_FALSE(json.contains("program"));
}

}  // namespace
}  // namespace slicefarm::engrave_report_test
