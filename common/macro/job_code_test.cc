#include "common/macro/job_code.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::macro::job_code_test {
namespace {

MotionOptions WithLayers(std::string layer_gcode, std::string start_gcode = "") {
  MotionOptions options;
  options.start_gcode = std::move(start_gcode);
  options.layer_gcode = std::move(layer_gcode);
  return options;
}

TEST(ParseJobCode, KnowsWhichLayersWait) {
  const auto waits = [](const MotionOptions& options) {
    const auto code = ParseJobCode(options);
    EXPECT_TRUE(code.ok()) << code.status();
    return code->layers_wait;
  };
  EXPECT_FALSE(waits(WithLayers("M117 {layer_num} of {total_layer_count}")));
  EXPECT_TRUE(waits(WithLayers("M117 {extruded_weight_total}")));
  EXPECT_TRUE(waits(WithLayers("{random(1, 2)}")));
  EXPECT_TRUE(waits(WithLayers("{global n = 1}")));
  EXPECT_TRUE(waits(WithLayers("{n}", "{global n = 1}")));
  MotionOptions of_filament = WithLayers("{n}");
  of_filament.tool().start_filament_gcode = "{global n = 1}";
  EXPECT_TRUE(waits(of_filament));
  EXPECT_FALSE(waits(WithLayers("{layer_num}", "{global n = 1}{extruded_weight_total}")));
}

TEST(CheckJobCode, NamesWhatIsWrongBeforeAnyWork) {
  EXPECT_TRUE(CheckJobCode(WithLayers("{n + layer_num}", "{global n = 1}"), "").ok());
  const ErrorDetail detail =
      DetailOf(CheckJobCode(WithLayers("G1\n{if layer_num > 3}[oops]{endif}"), ""));
  EXPECT_EQ(detail.reason, Reason::kSettingMalformed);
  EXPECT_EQ(detail.metadata.at("setting"), "layer_gcode");
  EXPECT_EQ(detail.metadata.at("line"), "2");
  EXPECT_EQ(detail.metadata.at("variable"), "oops");
  EXPECT_TRUE(CheckJobCode(WithLayers("[mine]"), "mine = 3\n").ok());
}

// The text of this template is made with its layer.
TEST(CheckJobCode, RefusesBetweenFeaturesWhatOnlyTheEndOfThePrintKnows) {
  MotionOptions options;
  const auto check = [&](const char* code) {
    options.role_gcode = code;
    return CheckJobCode(options, "mine = 3\n");
  };
  EXPECT_TRUE(check("; [extrusion_role] {layer_num} of {total_layer_count} [mine]").ok());
  EXPECT_TRUE(check("{if mine > 3}[print_time]{endif}").ok()) << "it never runs";
  for (const char* name : {"print_time", "used_filament", "extruded_weight_total"}) {
    const absl::Status refusal =
        check((std::string("{if layer_num > 3}{") + name + "}{endif}").c_str());
    EXPECT_EQ(DetailOf(refusal).reason, Reason::kSettingMalformed) << name;
    EXPECT_EQ(DetailOf(refusal).metadata["setting"], "change_extrusion_role_gcode");
    EXPECT_EQ(DetailOf(refusal).metadata["variable"], name);
    EXPECT_NE(refusal.message().find("only after"), absl::string_view::npos) << refusal;
  }
  options.role_gcode = "";
  options.between_objects_gcode = "; {print_time}";
  EXPECT_TRUE(CheckJobCode(options, "").ok()) << "it is filled in at the end";
}

TEST(NamesClock, IsTheTimeOfCreation) {
  EXPECT_TRUE(NamesClock(*ParseJobCode(WithLayers("", "; [timestamp]"))));
  EXPECT_TRUE(NamesClock(*ParseJobCode(WithLayers("{hour}"))));
  EXPECT_FALSE(NamesClock(*ParseJobCode(WithLayers("{layer_num}", "; hour"))));
}

}  // namespace
}  // namespace slicefarm::macro::job_code_test
