#include "services/exposure/algo/writers/custom_laser_code.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::exposure::custom_laser_code_test {
namespace {

ExposureSummary TwoLayers() {
  ExposureSummary summary;
  summary.layers = {{0, 50'000, 50'000}, {1, 100'000, 50'000}};
  summary.object_names = {"gear.stl"};
  summary.settings_text = "recoating_time = 8\n";
  return summary;
}

TEST(CustomLaserCode, IsFilledInInTheOrderOfTheFile) {
  ExposureOutput output;
  output.start_gcode = "{global n = 10}; [model_name] {layer_num}";
  output.before_layer_gcode = "{n = n + 1}M5\n";
  output.layer_gcode = "M100 L{layer_num} Z{layer_z} P[recoating_time] N{n}";
  output.end_gcode = "; {layer_num} {n}";
  const auto code = FillIn(output, TwoLayers());
  ASSERT_TRUE(code.ok()) << code.status();
  EXPECT_EQ(code->start, "; gear.stl -1\n");
  ASSERT_EQ(code->layers.size(), 2u);
  EXPECT_EQ(code->layers[0].before, "M5\n");
  EXPECT_EQ(code->layers[0].after, "M100 L0 Z0.05 P8 N11\n");
  EXPECT_EQ(code->layers[1].after, "M100 L1 Z0.1 P8 N12\n");
  EXPECT_EQ(code->end, "; 1 12\n");
}

TEST(CustomLaserCode, WithoutTemplatesIsEmpty) {
  const auto code = FillIn({}, TwoLayers());
  ASSERT_TRUE(code.ok()) << code.status();
  EXPECT_EQ(code->start + code->layers[0].before + code->layers[1].after + code->end, "");
  EXPECT_EQ(code->layers.size(), 2u);
}

TEST(CustomLaserCode, TellsWhatFails) {
  ExposureOutput output;
  output.layer_gcode = "{1 / layer_num}";  // division by zero in layer 0
  const auto code = FillIn(output, TwoLayers());
  EXPECT_EQ(DetailOf(code.status()).reason, Reason::kSettingMalformed);
  EXPECT_EQ(DetailOf(code.status()).metadata.at("setting"), "layer_gcode");
}

}  // namespace
}  // namespace slicefarm::exposure::custom_laser_code_test
