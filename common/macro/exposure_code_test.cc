#include "common/macro/exposure_code.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/macro/template_run.h"

namespace slicefarm::macro::exposure_code_test {
namespace {

TEST(CheckExposureCode, TakesWhatPrintsAndSettingsTell) {
  ExposureOutput output;
  output.format = OutputFormat::kGrbl;
  output.start_gcode = "; [model_name]: {total_layer_count} layers, [print_time], [contours]";
  output.before_layer_gcode = "{if layer_num > 0}M100 Z{layer_z + 1}{endif}";
  output.layer_gcode = "{first_layer_print_max[0] - first_layer_print_min[0]}";
  output.end_gcode = "G0 Z{max_print_z + 5}";
  EXPECT_TRUE(CheckExposureCode(output, "contours = 2\n").ok())
      << CheckExposureCode(output, "contours = 2\n");
}

TEST(CheckExposureCode, NamesWhatIsWrongBeforeAnyWork) {
  struct Case {
    std::string ExposureOutput::*text;
    const char* setting;
  };
  const Case kCases[] = {{&ExposureOutput::start_gcode, "start_gcode"},
                         {&ExposureOutput::before_layer_gcode, "before_layer_gcode"},
                         {&ExposureOutput::layer_gcode, "layer_gcode"},
                         {&ExposureOutput::end_gcode, "end_gcode"}};
  for (const Case& c : kCases) {
    for (const char* code : {"G4\n[oops]", "G4\n{layer_z + }", "G4\n{extruded_volume}"}) {
      ExposureOutput output;
      output.*c.text = code;
      EXPECT_TRUE(CheckExposureCode(output, "").ok()) << "no G-code";
      output.format = OutputFormat::kMarlin;
      const ErrorDetail detail = DetailOf(CheckExposureCode(output, ""));
      EXPECT_EQ(detail.reason, Reason::kSettingMalformed) << code;
      EXPECT_EQ(detail.metadata.at("setting"), c.setting);
      EXPECT_EQ(detail.metadata.at("line"), "2");
    }
  }
}

TEST(ExposureVariables, AreThoseOfThePrint) {
  const ExposureSummary summary{{{0, 50'000, 50'000}, {1, 100'000, 50'000}},
                                {{1'000'000, 2'000'000}, {4'000'000, 8'000'000}},
                                {"gear.stl", "b"},
                                3723,
                                ""};
  const TemplateVariables print = ExposurePrintVariables(summary);
  const TemplateVariables layer = ExposureLayerVariables(1, 100'000);
  const auto code = ParseTemplate(
      "layer_gcode",
      "{layer_num}/{total_layer_count} {layer_z} {max_print_z} [print_time] "
      "{first_layer_print_min[0]} {first_layer_print_size[1]} [model_name] [input_filename_base]");
  ASSERT_TRUE(code.ok()) << code.status();
  TemplateMemory memory;
  EXPECT_EQ(*RunTemplate(*code, {print, layer}, memory), "1/2 0.1 0.1 1h 2m 3s 1 6 gear.stl gear");
}

}  // namespace
}  // namespace slicefarm::macro::exposure_code_test
