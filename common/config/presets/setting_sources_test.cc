#include "common/config/presets/setting_sources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::config::presets::setting_sources_test {
namespace {

using testing::ElementsAre;

TEST(LastSources, HaveEachKeyOnce) {
  EXPECT_THAT(LastSources({{"a", {"x", "y"}}, {"b", {"z", "x"}}, {"c", {"z"}}, {"a", {"w"}}}),
              ElementsAre(SettingSource{"a", {"w", "y"}}, SettingSource{"b", {"x"}},
                          SettingSource{"c", {"z"}}));
}

TEST(SourcesOf, AreUnderTheNamesThatTheJobHas) {
  const std::vector<LabelledSetting> settings = {{{"wall_loops", "4"}, "process"},
                                                 {{"layer_height", "0.2"}, "parent"},
                                                 {{"nozzle_temperature", R"(["215"])"}, "filament"},
                                                 {{"no_such_key", "1"}, "parent"}};
  EXPECT_THAT(SourcesOf(PresetDialect::kOrca, settings),
              ElementsAre(SettingSource{"process", {"perimeters"}},
                          SettingSource{"parent", {"layer_height"}},
                          SettingSource{"filament", {"temperature"}}));
  EXPECT_THAT(SourcesOf(PresetDialect::kPrusa, {{{"perimeters", "4"}, "a"}, {{"b", "1"}, "a"}}),
              ElementsAre(SettingSource{"a", {"perimeters", "b"}}));
}

TEST(SourceText, NamesKindPresetAndFile) {
  Preset preset;
  preset.kind = PresetKind::kFilament;
  preset.name = "PLA\n";
  preset.file = "vendor@2/a.ini";
  EXPECT_EQ(SourceText(preset), R"(filament preset "PLA?" (vendor@2/a.ini))");
}

}  // namespace
}  // namespace slicefarm::config::presets::setting_sources_test
