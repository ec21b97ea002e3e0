#include "services/motion/algo/macro/template_variables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/macro/setting_variables.h"
#include "common/macro/template_run.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion::template_variables_test {
namespace {

using macro::ExpandTemplate;
using macro::TemplateVariables;

std::string Filled(std::string_view code, const TemplateVariables& variables) {
  return ExpandTemplate("g", code, variables).value_or("error");
}

// The values that the stage uses override the quoted settings.
TEST(JobVariables, OptionsThenSettingsThenDefaults) {
  MotionOptions options;
  options.tool().first_layer_temperature_c = 215;
  options.tool().filament_type = "PETG";
  const TemplateVariables variables =
      JobVariables(options, "temperature = 999\nperimeters = 3\nbed_shape = 0x0,9x0,9x8\n");
  EXPECT_EQ(Filled("{temperature[0]} {first_layer_temperature[0]} {filament_type[0]} {perimeters} "
                   "{print_bed_max[1]} {initial_filament_type} {wipe_tower}",
                   variables),
            "200 215 PETG 3 8 PETG false");
}

TEST(LayerVariables, ArePlaces) {
  JobFacts facts;
  facts.layer_count = 40;
  const TemplateVariables variables = LayerVariables({1, 3, 7, 800'000, 900'000}, facts);
  EXPECT_EQ(Filled("{layer_num} {layer_z} {max_layer_z} {current_object_idx} {total_layer_count}",
                   variables),
            "7 0.8 0.9 1 40");
  EXPECT_FALSE(LayerVariables({}, {}).contains("total_layer_count"));
}

TEST(PrintVariables, WholePrint) {
  ProgramSummary summary;
  summary.layers.resize(2);
  summary.total.bounds = {{FromMm(-5), FromMm(0)}, {FromMm(90), FromMm(80)}};  // wider than layer 0
  summary.total.features[0].filament_mm = 1'500;
  summary.layers[0].footprint = {
      {FromMm(10), FromMm(20)}, {FromMm(40), FromMm(20)}, {FromMm(40), FromMm(25)}};
  summary.copies = {{{"a.b.stl", 0, 0, 2}, {{0, 0}, {FromMm(2), 0}, {FromMm(2), FromMm(3)}}},
                    {{"a.b.stl", 0, 1, 2}, {}}};
  const TemplateVariables variables = PrintVariables(MotionOptions{}, summary, 3723);
  EXPECT_EQ(Filled("{total_layer_count} {first_layer_print_min[0]} {first_layer_print_size[1]} "
                   "{used_filament} {input_filename_base} {num_objects} {print_time} "
                   "{size(first_layer_print_convex_hull)} {first_layer_print_convex_hull[2]}",
                   variables),
            "2 10 5 1.5 a.b 2 1h 2m 3s 3 40,25");
  summary.copies[0].name.object_name = "a\nM112.stl";
  EXPECT_EQ(Filled("[input_filename_base]", PrintVariables(MotionOptions{}, summary, 0)), "a M112");
  EXPECT_EQ(Filled("{first_layer_print_size[0]}", PrintVariables(MotionOptions{}, {}, 0)), "0");
}

TEST(PutUseSoFar, IsVolumeAndMass) {
  TemplateVariables variables;
  PutUseSoFar(MotionOptions{}, 1000, 100, variables);
  EXPECT_EQ(Filled("{extruded_volume_total} {extruded_weight[0]}", variables), "2405.28 2.98255");
}

// The check before the print uses the same variables as the print.
TEST(VariablesOfThePrint, AreThoseThatAreFilledIn) {
  TemplateVariables filled = PrintVariables(MotionOptions{}, {}, 0);
  PutUseSoFar(MotionOptions{}, 0, 0, filled);
  JobFacts facts;
  facts.layer_count = 1;
  filled.merge(LayerVariables({}, facts));
  const TemplateVariables checked = macro::VariablesOfThePrint();
  ASSERT_FALSE(filled.empty());
  for (const auto& [name, variable] : filled) {
    ASSERT_TRUE(checked.contains(name)) << name;
    EXPECT_EQ(checked.at(name).is_list, variable.is_list) << name;
  }
  for (const auto& [name, variable] : checked) EXPECT_TRUE(filled.contains(name)) << name;
}

}  // namespace
}  // namespace slicefarm::motion::template_variables_test
