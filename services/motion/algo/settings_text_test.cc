#include "services/motion/algo/settings_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::motion {
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

}  // namespace
}  // namespace slicefarm::motion
