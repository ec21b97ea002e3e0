#include "common/macro/settings_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::macro::settings_text_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Pair;

TEST(SettingLines, KeysAndValues) {
  EXPECT_THAT(SettingLines("a = 1\n b=x = y \nnothing\n\nempty ="),
              ElementsAre(Pair("a", "1"), Pair("b", "x = y"), Pair("empty", "")));
  EXPECT_THAT(SettingLines(""), IsEmpty());
}

TEST(UnescapeSetting, EscapesAndQuotes) {
  EXPECT_EQ(UnescapeSetting("G28\\nG1 Z5\\r\\\\"), "G28\nG1 Z5\r\\");
  EXPECT_EQ(UnescapeSetting("\"PLA; \\\"red\\\"\""), "PLA; \"red\"");
  EXPECT_EQ(UnescapeSetting("\\"), "\\");
}

struct ItemsCase {
  std::string name;
  std::string key;
  std::string value;
  std::vector<std::string> want;
};

class SettingItemsTest : public testing::TestWithParam<ItemsCase> {};

TEST_P(SettingItemsTest, Are) {
  EXPECT_EQ(SettingItems(GetParam().key, GetParam().value), GetParam().want);
}

INSTANTIATE_TEST_SUITE_P(
    Values, SettingItemsTest,
    testing::Values(ItemsCase{"One", "printer_model", "MK3S", {"MK3S"}},
                    ItemsCase{"Nothing", "printer_notes", "", {""}},
                    ItemsCase{"EmptyText", "filament_notes", "\"\"", {""}},
                    ItemsCase{"TextOfItsOwn", "printer_notes", "a; b\\nc", {"a; b\nc"}},
                    ItemsCase{"List", "filament_vendor", "Prusa;Generic", {"Prusa", "Generic"}},
                    ItemsCase{"QuotedList",
                              "filament_notes",
                              "\"a; \\\"b\\\"\"; \"c\\nd\"",
                              {"a; \"b\"", "c\nd"}},
                    ItemsCase{"QuotedGcode", "end_filament_gcode", "\"; end\"", {"; end"}},
                    ItemsCase{"NoEnd", "filament_notes", "\"a;\\", {"\"a;\\"}}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace slicefarm::macro::settings_text_test
