#include "common/base/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::text_test {
namespace {

using testing::ElementsAre;

TEST(ReplaceControls, LeavesNothingThatEndsALineOrMovesACursor) {
  EXPECT_EQ(ReplaceControls(std::string("a\nb\rc\0d\x7f\x1b[2J", 12), '?'), "a?b?c?d??[2J");
  EXPECT_EQ(ReplaceControls("a\u0085b\u009b2Jc\u2028d\u2029", ' '), "a b 2Jc d ");
  for (const char* clean : {"", "Schlüssel \u00a0 \u2027 \u202a 部品", "\xc2", "\xe2\x80"}) {
    EXPECT_EQ(ReplaceControls(clean, '?'), clean);
  }
}

TEST(Trim, TakesBlanksOffBothSides) {
  EXPECT_EQ(Trim(" \t a b\r\n"), "a b");
  EXPECT_EQ(Trim(" \r\n"), "");
  EXPECT_EQ(Trim(""), "");
}

TEST(Split, GivesOnePartMoreThanSeparators) {
  EXPECT_THAT(Split("a,b;c", ",;"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(Split(",", ","), ElementsAre("", ""));
  EXPECT_THAT(Split("", ","), ElementsAre(""));
}

TEST(ToNumber, TakesAllOfTheTextOrNothing) {
  EXPECT_EQ(ToNumber("-1.5e3"), -1500);
  EXPECT_EQ(ToNumber("+2"), 2);
  for (const char* text : {"", "1 ", " 1", "1x", "nan", "inf", "1e999", "0x1p3", "+"}) {
    EXPECT_EQ(ToNumber(text), std::nullopt) << text;
  }
}

}  // namespace
}  // namespace slicefarm::text_test
