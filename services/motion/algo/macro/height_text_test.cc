#include "services/motion/algo/macro/height_text.h"

#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"
#include "common/model/options/motion_options.h"
#include "services/motion/algo/macro/template_variables.h"

namespace slicefarm::motion::height_text_test {
namespace {

constexpr char kCodes[] =
    R"([{"z":0.6,"type":"color_change","text":"#00FF00"},{"z":0.75,"type":"pause","text":"nut"},)"
    R"({"z":1,"type":"template"},{"z":1,"type":"custom","text":"M300"},{"z":1.4,"type":"pause"}])";

MotionOptions Options() {
  MotionOptions options;
  options.writing.height_code = kCodes;
  options.writing.color_change_gcode = "M600 ;[layer_num]";
  options.writing.pause_gcode = "M601";
  options.writing.template_gcode = "M400 S{layer_z}";
  options.layer_gcode = "M117 [layer_num]";
  return options;
}

LayerFrame Layer(int32_t index) {
  return {.index = index, .print_z_nm = (index + 1) * 200'000, .height_nm = 200'000};
}

std::string At(const HeightTexts& texts, const macro::JobCode& code, int32_t index) {
  const LayerFrame layer = Layer(index);
  const macro::TemplateVariables job;
  const macro::TemplateVariables now =
      LayerVariables({.number = index, .print_z_nm = layer.print_z_nm}, {});
  macro::TemplateMemory memory;
  const auto text = texts.At(layer, code, {job, now}, memory);
  EXPECT_TRUE(text.ok()) << text.status();
  return text.value_or("");
}

TEST(HeightTexts, StandInTheLayerThatReachesThem) {
  const auto texts = HeightTexts::Of(Options());
  const auto code = macro::ParseJobCode(Options());
  ASSERT_TRUE(texts.ok() && code.ok()) << code.status();
  const std::string want[] = {"",
                              "",
                              ";COLOR_CHANGE,T0,#00FF00\nM600 ;2\n",
                              ";PAUSE_PRINT\nM117 nut\nM601\n",
                              ";CUSTOM_GCODE\nM400 S1\n;CUSTOM_GCODE\nM300\n",
                              "",
                              ";PAUSE_PRINT\nM601\n",
                              ""};
  for (int32_t i = 0; i < std::ssize(want); ++i) {
    EXPECT_EQ(At(*texts, *code, i), want[i]) << i;
    EXPECT_EQ(texts->IsAt(Layer(i)), !want[i].empty()) << i;
    EXPECT_EQ(texts->PrimesAt(Layer(i)), i == 2) << i;
  }
}

TEST(HeightTexts, NameTheToolThatPrints) {
  MotionOptions options = Options();
  options.tool().number = 3;
  const auto texts = HeightTexts::Of(options);
  const auto code = macro::ParseJobCode(options);
  EXPECT_EQ(At(*texts, *code, 2), ";COLOR_CHANGE,T3,#00FF00\nM600 ;2\n");
}

TEST(HeightTexts, FollowLayerGcode) {
  const auto texts = HeightTexts::Of(Options());
  const auto code = macro::ParseJobCode(Options());
  const macro::TemplateVariables job;
  const macro::TemplateVariables now = LayerVariables({.number = 6, .print_z_nm = 1'400'000}, {});
  macro::TemplateMemory memory;
  EXPECT_EQ(*CodeAfterChange(Layer(6), *code, *texts, {job, now}, memory),
            "M117 6\n;PAUSE_PRINT\nM601\n");
  EXPECT_EQ(*CodeAfterChange(Layer(0), *code, *texts, {job, now}, memory), "M117 6");
}

TEST(HeightTexts, WaitForOtherLayersWhereTemplatesDo) {
  MotionOptions options = Options();
  EXPECT_FALSE(macro::ParseJobCode(options)->layers_wait);
  options.writing.pause_gcode = "M117 {extruded_volume_total}";
  EXPECT_TRUE(macro::ParseJobCode(options)->layers_wait);
  options.writing.height_code.clear();
  EXPECT_FALSE(macro::ParseJobCode(options)->layers_wait);
}

TEST(HeightTexts, ErrorsNameTheSetting) {
  MotionOptions options;
  options.writing.height_code = "{";
  EXPECT_EQ(DetailOf(HeightTexts::Of(options).status()).metadata.at("setting"),
            "custom_gcode_per_print_z");
  options = Options();
  options.writing.color_change_gcode = "{oops";
  EXPECT_EQ(DetailOf(macro::ParseJobCode(options).status()).metadata.at("setting"),
            "color_change_gcode");
}

TEST(HeightTexts, ARetractionLastsUntilTheNextOne) {
  MotionOptions options;
  EXPECT_FALSE(HeightTexts::Of(options)->ChangesRetraction());
  options.writing.height_code = R"([{"z":0.5,"type":"retract_length","text":"0.2"},)"
                                R"({"z":0.81,"type":"retract_length","text":"0"}])";
  const auto texts = HeightTexts::Of(options);
  ASSERT_TRUE(texts.ok()) << texts.status();
  EXPECT_TRUE(texts->ChangesRetraction());
  const double want[] = {0.8, 0.8, 0.2, 0.2, 0, 0};
  for (int32_t i = 0; i < std::ssize(want); ++i)
    EXPECT_EQ(texts->RetractLengthMm(Layer(i).print_z_nm, 0.8), want[i]) << i;
  EXPECT_EQ(At(*texts, {}, 2), "; retract_length = 0.2\n");
}

}  // namespace
}  // namespace slicefarm::motion::height_text_test
