#include "processes/mill/settings/mill_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/config/projects/ini.h"
#include "common/config/resolve.h"
#include "common/config/setting_pairs_test.h"
#include "processes/mill/model/milling_options.h"

namespace slicefarm::config::mill::mill_settings_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

absl::StatusOr<ResolvedSettings> OfMill(const Pairs& given) {
  std::vector<Setting> settings;
  for (const auto& [key, value] : given) settings.push_back({key, value, Source::kRequest});
  return Resolve(settings, Process::kMill);
}

TEST(ResolveMill, EverySettingReachesItsOption) {
  const auto resolved = OfMill({{"cutter", "bull:6.0:1"},
                                {"stepdown", "0.5"},
                                {"stepover", "25%"},
                                {"entry", "ramp"},
                                {"spindle", "9000"},
                                {"stock", "blank.stl"},
                                {"origin", "stock_top"},
                                {"dialect", "grbl"}});
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  const MillSettings& mill = MillOf(resolved->settings);
  EXPECT_EQ(mill.how.cutter.name(), "bull:6:1");
  EXPECT_EQ(mill.how.stepdown_mm, 0.5);
  EXPECT_EQ(mill.how.stepover_share, 0.25);
  EXPECT_EQ(mill.how.machining.entry, EntryKind::kRamp);
  EXPECT_EQ(mill.how.machining.spindle_rpm, 9000);
  EXPECT_EQ(mill.stock, "blank.stl");
  EXPECT_EQ(mill.origin, MillOrigin::kStockTop);
  EXPECT_EQ(mill.dialect, MillDialect::kGrbl);
  EXPECT_THAT(TextsOf(resolved->no_effect), IsEmpty());
}

// The default values in the table equal the default values of the options.
TEST(ResolveMill, StandardsAreTheDefaults) {
  const auto resolved = OfMill({});
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  EXPECT_EQ(MillOf(resolved->settings), MillSettings());
}

TEST(ResolveMill, ReadsItsOwnEffectiveText) {
  const auto first = OfMill({{"cutter", "ballcone:2:20:6"}, {"stock", "a b.stl"}});
  ASSERT_TRUE(first.ok()) << first.status();
  const auto lines = ReadIni(first->effective_text);
  ASSERT_TRUE(lines.ok()) << lines.status();
  const auto second = Resolve(*lines, Process::kMill);
  ASSERT_TRUE(second.ok()) << second.status();
  EXPECT_EQ(second->settings, first->settings);
  EXPECT_EQ(second->effective_text, first->effective_text);
}

TEST(ResolveMill, NamesWhatCannotBe) {
  struct Case {
    Pairs given;
    Reason reason;
    const char* setting;
    const char* words;
  };
  for (const Case& c : {
           Case{{{"cutter", "drill:6"}}, Reason::kSettingMalformed, "cutter", "bull:D:CORNER"},
           Case{
               {{"cutter", "conecone:2:20:60:6"}}, Reason::kSettingOutOfRange, "cutter", "steeper"},
           Case{{{"cutter", "bull:4:3"}}, Reason::kSettingOutOfRange, "cutter", "corner radius"},
           Case{{{"cutter", "cone:4:90"}}, Reason::kSettingOutOfRange, "cutter", "half angle"},
           Case{{{"stepover", "60%"}}, Reason::kSettingOutOfRange, "stepover", "50"},
           Case{{{"helix_radius", "3"}}, Reason::kSettingOutOfRange, "helix_radius", "2"},
           Case{{{"finish_stepover", "5"}}, Reason::kSettingOutOfRange, "finish_stepover", "4"},
           Case{{{"clearance", "7"}}, Reason::kSettingOutOfRange, "clearance", "5"},
           Case{{{"entry", "dive"}}, Reason::kSettingMalformed, "entry", "helix, ramp, plunge"},
           Case{{{"perimeters", "3"}}, Reason::kSettingOfOtherProcess, "perimeters", "fdm"},
       }) {
    SCOPED_TRACE(c.given.front().second);
    const absl::Status status = OfMill(c.given).status();
    EXPECT_EQ(DetailOf(status).reason, c.reason) << status;
    EXPECT_EQ(DetailOf(status).metadata["setting"], c.setting) << status;
    EXPECT_THAT(std::string(status.message()), HasSubstr(c.words));
  }
}

TEST(ResolveMill, TellsWhatHasNoEffect) {
  const auto resolved = OfMill({{"finishing", "0"},
                                {"rest_angle", "30"},
                                {"entry", "ramp"},
                                {"helix_radius", "1"},
                                {"output_step", "2"}});
  ASSERT_TRUE(resolved.ok()) << resolved.status();
  EXPECT_THAT(TextsOf(resolved->no_effect),
              ElementsAre("helix_radius = 1: needs entry = helix",
                          "output_step = 2: needs output_format = svg",
                          "rest_angle = 30: needs finishing = 1"));
}

}  // namespace
}  // namespace slicefarm::config::mill::mill_settings_test
