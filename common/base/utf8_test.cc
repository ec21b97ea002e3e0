#include "common/base/utf8.h"

#include <gtest/gtest.h>

namespace slicefarm::utf8_test {
namespace {

struct Case {
  std::string name;
  std::string text;
  std::string want;
};

class Utf8 : public testing::TestWithParam<Case> {};

TEST_P(Utf8, ReplacesWhatIsNone) { EXPECT_EQ(ToUtf8(GetParam().text, 100), GetParam().want); }

TEST_P(Utf8, KnowsWhatIsNone) {
  EXPECT_EQ(IsUtf8(GetParam().text), GetParam().text == GetParam().want);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, Utf8,
    testing::Values(
        Case{"Empty", "", ""}, Case{"Ascii", "layer\n", "layer\n"},
        Case{"TwoThreeAndFourBytes", "\xc3\xa4\xe2\x82\xac\xf0\x9f\x90\x9f",
             "\xc3\xa4\xe2\x82\xac\xf0\x9f\x90\x9f"},
        Case{"Latin1", "M\xfcller", "M?ller"}, Case{"LoneContinuation", "a\x80z", "a?z"},
        Case{"CutShort", "a\xe2\x82", "a??"}, Case{"CutShortByAscii", "\xe2\x82z", "??z"},
        Case{"OverlongSlash", "\xc0\xaf", "??"}, Case{"OverlongThree", "\xe0\x80\xaf", "???"},
        Case{"OverlongFour", "\xf0\x80\x80\xaf", "????"}, Case{"Surrogate", "\xed\xa0\x80", "???"},
        Case{"BeyondUnicode", "\xf4\x90\x80\x80", "????"},
        Case{"LastOfUnicode", "\xf4\x8f\xbf\xbf", "\xf4\x8f\xbf\xbf"}),
    [](const auto& info) { return info.param.name; });

TEST(Utf8Limit, CutsBetweenCharacters) {
  EXPECT_EQ(ToUtf8("abc", 3), "abc");
  EXPECT_EQ(ToUtf8("abc", 2), "ab");
  EXPECT_EQ(ToUtf8("a\xe2\x82\xac", 3), "a");
  EXPECT_EQ(ToUtf8("a\xe2\x82\xac", 4), "a\xe2\x82\xac");
  EXPECT_EQ(ToUtf8("abc", 0), "");
}

}  // namespace
}  // namespace slicefarm::utf8_test
