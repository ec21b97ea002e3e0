#include "common/config/table/suggest.h"

#include <gtest/gtest.h>

#include <string>

#include "common/config/table/settings_table.h"

namespace slicefarm::config::suggest_test {
namespace {

TEST(EditDistance, CountsSteps) {
  struct Case {
    const char* a;
    const char* b;
    int want;
  };
  const Case kCases[] = {{"", "", 0},       {"", "abc", 3},          {"abc", "abc", 0},
                         {"abc", "abd", 1}, {"abc", "acb", 1},       {"abc", "ab", 1},
                         {"ca", "abc", 3},  {"kitten", "sitting", 3}};
  for (const Case& c : kCases) {
    EXPECT_EQ(EditDistance(c.a, c.b), c.want) << c.a << " " << c.b;
    EXPECT_EQ(EditDistance(c.b, c.a), c.want) << c.b << " " << c.a;
  }
}

TEST(NearestSetting, FindsWhatWasMeant) {
  const std::pair<const char*, const char*> kCases[] = {
      {"layer_hieght", "layer_height"},
      {"layerheight", "layer_height"},
      {"perimeter", "perimeters"},
      {"fil_density", "fill_density"},
      {"elephant_foot_compensation", "elefant_foot_compensation"},
      {"seam_positon", "seam_position"},
      {"nozzle_diametre", "nozzle_diameter"},
      {"external_perimeter_sped", "external_perimeter_speed"},
  };
  for (const auto& [key, want] : kCases) EXPECT_EQ(NearestSetting(key, Process::kFdm), want) << key;
}

TEST(NearestSetting, FindsOneLetterAnywhereInAnyKey) {
  ASSERT_FALSE(SettingsTable(Process::kFdm).empty());
  for (const SettingSpec& spec : SettingsTable(Process::kFdm)) {
    const std::string key(spec.key);
    for (size_t i = 0; i < key.size(); ++i) {
      std::string wrong = key;
      wrong[i] = '#';
      EXPECT_NE(NearestSetting(wrong, Process::kFdm), "") << wrong;
    }
  }
}

TEST(NearestSetting, SaysNothingWhereNothingComesNear) {
  EXPECT_EQ(NearestSetting("banana", Process::kFdm), "");
  EXPECT_EQ(NearestSetting("", Process::kFdm), "");
  EXPECT_EQ(NearestSetting(std::string(100'000, 'a'), Process::kFdm), "");
}

}  // namespace
}  // namespace slicefarm::config::suggest_test
