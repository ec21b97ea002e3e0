#include "common/model/options/cutter_text.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::cutter_text_test {
namespace {

TEST(ParseCutter, ReadsEachKind) {
  EXPECT_DOUBLE_EQ(ParseCutter("cyl:6")->radius_mm(), 3);
  EXPECT_DOUBLE_EQ(ParseCutter("ball:4")->Width(0), 0);
  EXPECT_DOUBLE_EQ(ParseCutter("bull:6:1")->Width(0), 2);
  EXPECT_NEAR(ParseCutter("cone:6:45")->full_height_mm(), 3, 1e-12);
  EXPECT_EQ(ParseCutter("ballcone:2:20:6")->pieces().size(), 3u);
  EXPECT_EQ(ParseCutter("bullcone:2:0.5:20:6")->pieces().size(), 3u);
  EXPECT_EQ(ParseCutter("conecone:2:60:20:6")->pieces().size(), 3u);
}

TEST(ParseCutter, RefusesWhatIsNone) {
  for (const char* text : {"", "cyl", "cyl:", "cyl:6:1", "bull:6", "drill:6", "cyl:six",
                           "cyl:6:", ":6", "bull::6:1", "CYL:6"}) {
    const auto cutter = ParseCutter(text);
    ASSERT_FALSE(cutter.ok()) << text;
    EXPECT_EQ(DetailOf(cutter.status()).reason, Reason::kSettingMalformed) << text;
  }
  EXPECT_EQ(DetailOf(ParseCutter("cyl:-6").status()).reason, Reason::kSettingOutOfRange);
}

}  // namespace
}  // namespace slicefarm::cutter_text_test
