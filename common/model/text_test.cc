#include "common/model/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm {
namespace {

using testing::ElementsAre;

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
}  // namespace slicefarm
