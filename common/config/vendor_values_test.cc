// Tests of values in the form of vendors' files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/config/resolve.h"
#include "common/config/setting_pairs_test.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::vendor_values_test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ResolvedSettings Profile(const Pairs& pairs) {
  auto resolved = Resolve(Settings(pairs, Source::kProfile), Process::kFdm);
  EXPECT_TRUE(resolved.ok()) << resolved.status();
  return resolved.ok() ? *std::move(resolved) : ResolvedSettings();
}

struct Case {
  std::string name;
  std::string key;
  std::string value;
  std::string effective;
  bool reported = true;
};

class VendorValueTest : public testing::TestWithParam<Case> {};

TEST_P(VendorValueTest, IsReadAsPrusaSlicerDoes) {
  const Case& c = GetParam();
  const ResolvedSettings resolved = Profile({{c.key, c.value}});
  EXPECT_THAT(resolved.effective_text, HasSubstr("\n" + c.key + " = " + c.effective + "\n"));
  if (c.reported)
    EXPECT_THAT(resolved.warnings, Contains(HasSubstr(c.key)));
  else
    EXPECT_THAT(resolved.warnings, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    Values, VendorValueTest,
    testing::Values(Case{"PercentOfNothing", "ironing_speed", "15%", "15"},
                    Case{"Comment", "deretract_speed", "40 Setting this to 0 uses the other", "40"},
                    Case{"CommentInList", "deretract_speed", "40 a,40 a", "40"},
                    Case{"Empty", "filament_cost", "", "0"},
                    Case{"EmptyTemperature", "bed_temperature", "", "0"},
                    Case{"Fast", "machine_max_feedrate_x", "13000", "13000", false},
                    Case{"Thick", "filament_diameter", "22.66", "22.66", false},
                    Case{"CornerWithoutX", "bed_shape", "0x0,235-0,235x235,0x235",
                         "0x0,235x0,235x235,0x235"},
                    Case{"OffsetWithoutX", "extruder_offset", "-20,10", "-20x0"}),
    [](const auto& info) { return info.param.name; });

TEST(Resolve, APersonMayNotWriteSo) {
  for (const auto& [key, value] : Pairs{{"ironing_speed", "15%"},
                                        {"deretract_speed", "40 mm"},
                                        {"filament_cost", ""},
                                        {"bed_shape", "0x0,235-0,235x235,0x235"}})
    EXPECT_EQ(DetailOf(Resolve(Settings({{key, value}}), Process::kFdm).status()).reason,
              Reason::kSettingMalformed)
        << key;
}

TEST(Resolve, ASequentialSkirtHasOneLayer) {
  const Pairs profile = {{"complete_objects", "1"}, {"skirts", "1"}, {"skirt_height", "3"}};
  const ResolvedSettings resolved = Profile(profile);
  EXPECT_THAT(resolved.effective_text, HasSubstr("\nskirt_height = 1\n"));
  EXPECT_THAT(resolved.warnings, Contains(HasSubstr("skirt_height = 3")));
  EXPECT_FALSE(Resolve(Settings(profile), Process::kFdm).ok()) << "of a person";
}

TEST(Resolve, TemplatesAreCheckedBeforeAnyWork) {
  const auto refusal = [](const char* key, const char* code) {
    return DetailOf(Resolve(Settings({{key, code}}), Process::kFdm).status());
  };
  EXPECT_EQ(refusal("layer_gcode", "{if layer_num > 9}[oops]{endif}").metadata.at("variable"),
            "oops");
  EXPECT_EQ(refusal("end_gcode", "M104 {").metadata.at("setting"), "end_gcode");
  EXPECT_EQ(refusal("start_filament_gcode", "[oops]").metadata.at("variable"), "oops");
  EXPECT_TRUE(Resolve(Settings({{"start_gcode", "{if false}[oops]{endif}"}}), Process::kFdm).ok());
  EXPECT_TRUE(
      Resolve(Settings({{"mine", "3"}, {"layer_gcode", "[mine]"}}, Source::kProfile), Process::kFdm)
          .ok());
}

// Equal jobs have equal texts, and so equal bytes, unless their G-code contains the time.
TEST(Resolve, CreationTimeCountsOnlyIfItIsNamed) {
  const Pairs early = {{"creation_time", "2026-01-02T03:04:05Z"}};
  EXPECT_EQ(Profile(early).effective_text, Profile({}).effective_text);
  Pairs named = early;
  named.push_back({"start_gcode", "; [timestamp]"});
  EXPECT_THAT(Profile(named).effective_text, HasSubstr("creation_time = 2026-01-02T03:04:05Z"));
  EXPECT_EQ(DetailOf(Resolve(Settings({{"start_gcode", "; [timestamp]"}}), Process::kFdm).status())
                .metadata.at("variable"),
            "timestamp");
}

TEST(Resolve, ToldByWeight) {
  const ResolvedSettings resolved = Profile(
      {{"a_new_key", "1"}, {"notes", "mine"}, {"colorprint_heights", "5"}, {"wipe_tower", "1"}});
  const std::vector<std::string> notes = TextsOf(resolved.no_effect);
  ASSERT_EQ(notes.size(), 2u) << "notes and towers change no print";
  EXPECT_TRUE(notes[0].starts_with("colorprint_heights"));
  EXPECT_TRUE(notes[1].starts_with("a_new_key"));
}

TEST(Resolve, InfillIsNoFasterThanItsFilament) {
  const auto speed = [](Pairs pairs) {
    pairs.insert(pairs.begin(), {{"infill_speed", "200"}, {"solid_infill_speed", "50%"}});
    return FdmOf(Profile(pairs).settings).region.motion;
  };
  const auto sparse = [&](const Pairs& pairs) {
    return speed(pairs).speed_mm_s[static_cast<size_t>(Feature::kInternalInfill)];
  };
  EXPECT_EQ(sparse({{"filament_infill_max_speed", "80"}, {"fill_pattern", "gyroid"}}), 80);
  EXPECT_EQ(sparse({{"filament_infill_max_speed", "80"}, {"fill_pattern", "grid"}}), 200);
  EXPECT_EQ(sparse({{"filament_infill_max_crossing_speed", "60"}, {"fill_pattern", "grid"}}), 60);
  EXPECT_EQ(speed({{"filament_infill_max_speed", "80"}, {"fill_pattern", "gyroid"}})
                .speed_mm_s[static_cast<size_t>(Feature::kSolidInfill)],
            100);
}

}  // namespace
}  // namespace slicefarm::config::vendor_values_test
