#include "services/motion/algo/macro/layer_code.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion::layer_code_test {
namespace {

TEST(LayerCode, IsFilledInForEachLayer) {
  MotionOptions options;
  options.before_layer_gcode = ";BEFORE_LAYER_CHANGE {layer_z}";
  options.layer_gcode = "[layer_num] of [total_layer_count] {layer_height}";
  options.layer_settings = "layer_height = 0.2\n";
  const auto layers = LayerCode::Of(options);
  ASSERT_TRUE(layers.ok()) << layers.status();
  JobFacts facts;
  facts.layer_count = 40;
  const auto code =
      layers->At({}, {.number = 7, .print_z_nm = 1'600'000, .top_nm = 1'600'000}, facts);
  ASSERT_TRUE(code.ok()) << code.status();
  EXPECT_EQ(code->before, ";BEFORE_LAYER_CHANGE 1.6");
  EXPECT_EQ(code->after, "7 of 40 0.2");
  EXPECT_TRUE(code->names_layer_change);
  EXPECT_TRUE(code->has_after);
  EXPECT_FALSE(code->waits);
}

TEST(LayerCode, WaitsForSums) {
  MotionOptions options;
  options.layer_gcode = "M117 {extruded_volume_total}";
  const auto code = LayerCode::Of(options)->At({}, {}, {});
  ASSERT_TRUE(code.ok()) << code.status();
  EXPECT_TRUE(code->waits);
  EXPECT_EQ(code->after, "");
}

TEST(LayerCode, KnowsCodeThatMovesTheNozzle) {
  const std::pair<const char*, bool> cases[] = {{"M117 X", false},      {"G1 E-1 F60", false},
                                                {"G1 X5 ; away", true}, {"G4 P1\nG0 Z9", true},
                                                {"; G1 X5", false},     {"G92 X0", false}};
  for (const auto& [text, moves] : cases) {
    MotionOptions options;
    options.layer_gcode = text;
    EXPECT_EQ(LayerCode::Of(options)->At({}, {}, {})->moves, moves) << text;
    options.layer_gcode = "";
    options.writing.height_code = PrintHeightCodes({{100'000, HeightCodeKind::kCustom, text}});
    const LayerFrame first = {.index = 0, .print_z_nm = 200'000, .height_nm = 200'000};
    EXPECT_EQ(LayerCode::Of(options)->At(first, {}, {})->moves, moves) << text;
  }
}

TEST(LayerCode, ErrorsNameTheSetting) {
  MotionOptions options;
  options.layer_gcode = "{oops";
  EXPECT_EQ(DetailOf(LayerCode::Of(options).status()).metadata.at("setting"), "layer_gcode");
  options.layer_gcode = "{oops}";
  const absl::Status status = LayerCode::Of(options)->At({}, {}, {}).status();
  EXPECT_EQ(DetailOf(status).metadata.at("variable"), "oops");
}

}  // namespace
}  // namespace slicefarm::motion::layer_code_test
