#include "common/macro/template_defaults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "common/macro/settings_text.h"

namespace slicefarm::macro::template_defaults_test {
namespace {

TEST(TemplateDefaults, AreSortedAndUnique) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : SettingLines(TemplateDefaults())) keys.emplace_back(key);
  EXPECT_GT(keys.size(), 80);
  EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
  EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
}

// Compares with the values that PrusaSlicer 2.5 itself writes; later versions changed one of them.
TEST(TemplateDefaults, ArePrusaSlicers) {
  std::ifstream file(std::string(SLICEFARM_CORPUS) + "/config/prusaslicer_defaults.ini");
  ASSERT_TRUE(file.is_open());
  std::stringstream text;
  text << file.rdbuf();
  const std::string given = text.str();
  std::map<std::string_view, std::string_view> theirs;
  for (const auto& [key, value] : SettingLines(given)) theirs[key] = value;
  int compared = 0;
  for (const auto& [key, value] : SettingLines(TemplateDefaults())) {
    const auto found = theirs.find(key);
    if (found == theirs.end() || key == "gcode_label_objects" || key.ends_with("_gcode")) continue;
    EXPECT_EQ(value, found->second == "\"\""
                         ? ""
                         : SettingItems(key, found->second)[0].substr(0, found->second.find(',')))
        << key;
    ++compared;
  }
  EXPECT_GT(compared, 40);
}

}  // namespace
}  // namespace slicefarm::macro::template_defaults_test
