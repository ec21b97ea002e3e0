#include "services/motion/algo/macro/template_variables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::motion::template_variables_test {
namespace {

using ::testing::ElementsAre;

TEST(LayerVariables, SettingsAndPlace) {
  MotionOptions options;
  options.first_layer_temperature_c = 215;
  options.filament_type = "PETG";
  const TemplateVariables variables = LayerVariables(options, {}, {0, 3, 3, 800'000, 800'000});
  EXPECT_THAT(variables.at("first_layer_temperature"), ElementsAre(TemplateValue(int64_t{215})));
  EXPECT_THAT(variables.at("filament_type"), ElementsAre(TemplateValue(std::string("PETG"))));
  EXPECT_THAT(variables.at("layer_num"), ElementsAre(TemplateValue(int64_t{3})));
  EXPECT_THAT(variables.at("layer_z"), ElementsAre(TemplateValue(0.8)));
  EXPECT_THAT(variables.at("initial_extruder"), ElementsAre(TemplateValue(int64_t{0})));
}

TEST(LayerVariables, WhatItsGcodeNames) {
  MotionOptions options;
  options.layer_settings = "layer_height = 0.2\nmax_print_height = 210\nbed_shape = 0x0,9x0,9x8\n";
  JobFacts facts;
  facts.layer_count = 40;
  const TemplateVariables variables = LayerVariables(options, facts, {1, 3, 7, 800'000, 900'000});
  EXPECT_THAT(variables.at("layer_height"), ElementsAre(TemplateValue(0.2)));
  EXPECT_THAT(variables.at("max_print_height"), ElementsAre(TemplateValue(int64_t{210})));
  EXPECT_THAT(variables.at("print_bed_max"), ElementsAre(TemplateValue(9.0), TemplateValue(8.0)));
  EXPECT_THAT(variables.at("layer_z"), ElementsAre(TemplateValue(0.8)));
  EXPECT_THAT(variables.at("max_layer_z"), ElementsAre(TemplateValue(0.9)));
  EXPECT_THAT(variables.at("layer_num"), ElementsAre(TemplateValue(int64_t{7})));
  EXPECT_THAT(variables.at("current_object_idx"), ElementsAre(TemplateValue(int64_t{1})));
  EXPECT_THAT(variables.at("total_layer_count"), ElementsAre(TemplateValue(int64_t{40})));
  EXPECT_THAT(variables.at("spiral_vase"), ElementsAre(TemplateValue(int64_t{0})));
  facts.layer_count = 0;
  EXPECT_FALSE(LayerVariables(options, facts, {}).contains("total_layer_count"));
}

TEST(ProgramVariables, WholePrintAndAllSettings) {
  ProgramSummary summary;
  summary.layers.resize(2);
  summary.layers[1].frame = {1, 400'000, 200'000};
  summary.total.bounds = {{FromMm(10), FromMm(20)}, {FromMm(40), FromMm(25)}};
  summary.total.features[0].filament_mm = 1'500;
  summary.copies = {{{"a.b.stl", 0, 0, 2}, {}}, {{"a.b.stl", 0, 1, 2}, {}}};
  summary.settings_text =
      "bed_shape = -10x0,200x0,200x180.5,oops,1x,x\n"
      "fill_density = 20%\nperimeters = 3\ntemperature = 999\nnotes = \"a\\nb\"\n";
  const TemplateVariables variables = ProgramVariables(MotionOptions{}, summary, 3723);
  EXPECT_THAT(variables.at("total_layer_count"), ElementsAre(TemplateValue(int64_t{2})));
  EXPECT_THAT(variables.at("max_layer_z"), ElementsAre(TemplateValue(0.4)));
  EXPECT_THAT(variables.at("first_layer_print_min"),
              ElementsAre(TemplateValue(10.0), TemplateValue(20.0)));
  EXPECT_THAT(variables.at("first_layer_print_size"),
              ElementsAre(TemplateValue(30.0), TemplateValue(5.0)));
  EXPECT_THAT(variables.at("print_bed_max"),
              ElementsAre(TemplateValue(200.0), TemplateValue(180.5)));
  EXPECT_THAT(variables.at("used_filament"), ElementsAre(TemplateValue(1.5)));
  EXPECT_THAT(variables.at("input_filename_base"), ElementsAre(TemplateValue(std::string("a.b"))));
  EXPECT_THAT(variables.at("num_objects"), ElementsAre(TemplateValue(int64_t{2})));
  summary.copies[0].name.object_name = "a\nM112.stl";
  EXPECT_THAT(ProgramVariables(MotionOptions{}, summary, 0).at("input_filename_base"),
              ElementsAre(TemplateValue(std::string("a M112"))));
  EXPECT_THAT(variables.at("fill_density"), ElementsAre(TemplateValue(std::string("20%"))));
  EXPECT_THAT(variables.at("perimeters"), ElementsAre(TemplateValue(int64_t{3})));
  EXPECT_THAT(variables.at("notes"), ElementsAre(TemplateValue(std::string("a\nb"))));
  EXPECT_THAT(variables.at("print_time"), ElementsAre(TemplateValue(std::string("1h 2m 3s"))));
  // What the stage works with counts, not what is quoted.
  EXPECT_THAT(variables.at("temperature"), ElementsAre(TemplateValue(int64_t{200})));
}

TEST(ProgramVariables, NothingPrinted) {
  const TemplateVariables variables = ProgramVariables(MotionOptions{}, {}, 0);
  EXPECT_THAT(variables.at("first_layer_print_size"),
              ElementsAre(TemplateValue(0.0), TemplateValue(0.0)));
  EXPECT_THAT(variables.at("total_layer_count"), ElementsAre(TemplateValue(int64_t{0})));
}

// Profiles ask for these without knowing whether the job was given them.
TEST(ProgramVariables, PrusaSlicersValuesOfWhatWasNotGiven) {
  ProgramSummary summary;
  summary.settings_text =
      "print_settings_id = 0.2mm\nspiral_vase = 1\nfilament_notes = \"a;b\";\"c\"\n";
  const TemplateVariables variables = ProgramVariables(MotionOptions{}, summary, 0);
  const auto text = [](const char* value) { return TemplateValue(std::string(value)); };
  EXPECT_THAT(variables.at("print_preset"), ElementsAre(text("0.2mm")));
  EXPECT_THAT(variables.at("spiral_vase"), ElementsAre(TemplateValue(int64_t{1})));
  EXPECT_THAT(variables.at("filament_notes"), ElementsAre(text("a;b"), text("c")));
  EXPECT_THAT(variables.at("support_material"), ElementsAre(TemplateValue(int64_t{0})));
  EXPECT_THAT(variables.at("printer_notes"), ElementsAre(text("")));
  EXPECT_THAT(variables.at("filament_vendor"), ElementsAre(text("(Unknown)")));
  EXPECT_THAT(variables.at("initial_filament_type"), ElementsAre(text("PLA")));
  EXPECT_FALSE(variables.contains("timestamp"));
}

}  // namespace
}  // namespace slicefarm::motion::template_variables_test
