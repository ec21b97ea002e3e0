#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/config/resolve.h"
#include "common/config/setting_pairs_test.h"
#include "common/model/options/motion_options.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::resolve_writing_test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

ResolvedSettings ResolveOrDie(const std::vector<Setting>& settings) {
  auto resolved = Resolve(settings, Process::kFdm);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.value_or(ResolvedSettings());
}

absl::Status Refusal(const Pairs& pairs) {
  return Resolve(Settings(pairs), Process::kFdm).status();
}

TEST(ResolveWriting, ReadsHowGcodeIsWritten) {
  const WritingOptions none = FdmOf(ResolveOrDie({}).settings).machine.motion.writing;
  EXPECT_TRUE(none.relative_e);
  EXPECT_EQ(none.file_name, "[input_filename_base].gcode");
  EXPECT_EQ(none.color_change_gcode, "M600");
  const ResolvedSettings resolved =
      ResolveOrDie(Settings({{"use_relative_e_distances", "0"},
                             {"use_volumetric_e", "1"},
                             {"use_firmware_retraction", "1"},
                             {"retract_length", "0"},
                             {"gcode_comments", "1"},
                             {"binary_gcode", "1"},
                             {"gcode_substitutions", "\"M204\";\"M205\";\"\";\"\""},
                             {"custom_gcode_per_print_z", "[{\"type\":\"pause\",\"z\":1}]"},
                             {"output_filename_format", "{layer_height}.gcode"}}));
  const MotionOptions motion = MotionOf(FdmOf(resolved.settings));
  EXPECT_FALSE(motion.writing.relative_e);
  EXPECT_TRUE(motion.writing.volumetric_e && motion.writing.firmware_retraction);
  EXPECT_TRUE(motion.writing.comments && motion.writing.binary);
  EXPECT_EQ(motion.writing.height_code, "[{\"z\":1.0,\"type\":\"pause\"}]");
  EXPECT_EQ(motion.tool().retraction.length_mm, 1);
  EXPECT_TRUE(FdmOf(resolved.settings).machine.order.travel.retract_layer_change);
  EXPECT_THAT(resolved.effective_text, HasSubstr("\ngcode_substitutions = M204;M205;;\n"));
  EXPECT_THAT(TextsOf(resolved.no_effect), IsEmpty());
}

TEST(ResolveWriting, RefusesWhatNoFirmwareReads) {
  struct Case {
    Pairs given;
    const char* setting;
  };
  const Case cases[] = {
      {{{"use_firmware_retraction", "1"}, {"wipe", "1"}}, "use_firmware_retraction"},
      {{{"use_firmware_retraction", "1"}, {"gcode_flavor", "bambu"}}, "use_firmware_retraction"},
      {{{"use_volumetric_e", "1"}, {"gcode_flavor", "klipper"}}, "use_volumetric_e"},
      {{{"gcode_substitutions", "\"(\";\"\";\"r\";\"\""}}, "gcode_substitutions"},
      {{{"gcode_substitutions", "a;b"}}, "gcode_substitutions"},
      {{{"custom_gcode_per_print_z", "1,2"}}, "custom_gcode_per_print_z"},
      {{{"output_filename_format", "{oops}"}}, "output_filename_format"},
      {{{"custom_gcode_per_print_z", "[{\"z\":1,\"type\":\"pause\"}]"},
        {"pause_print_gcode", "{oops}"}},
       "pause_print_gcode"},
  };
  for (const Case& c : cases)
    EXPECT_EQ(DetailOf(Refusal(c.given)).metadata.at("setting"), c.setting) << c.setting;
  // No code runs this template.
  EXPECT_TRUE(Resolve(Settings({{"pause_print_gcode", "{oops}"}}), Process::kFdm).ok());
}

TEST(ResolveWriting, LimitsThatAreIgnoredAreThoseOfNoSetting) {
  const Pairs given = {{"machine_max_acceleration_x", "123"},
                       {"machine_max_jerk_e", "1"},
                       {"machine_min_travel_rate", "3"}};
  Pairs ignored = given;
  ignored.emplace_back("machine_limits_usage", "ignore");
  const MachineLimits none = FdmOf(ResolveOrDie({}).settings).machine.motion.limits;
  EXPECT_NE(FdmOf(ResolveOrDie(Settings(given)).settings).machine.motion.limits, none);
  EXPECT_EQ(FdmOf(ResolveOrDie(Settings(ignored)).settings).machine.motion.limits, none);
  ignored.back().second = "emit_to_gcode";
  EXPECT_TRUE(FdmOf(ResolveOrDie(Settings(ignored)).settings).machine.motion.limits.emit_to_gcode);
}

}  // namespace
}  // namespace slicefarm::config::resolve_writing_test
