#include "common/macro/regex.h"

#include <gtest/gtest.h>

#include <random>
#include <regex>

namespace slicefarm::macro::regex_test {
namespace {

struct Case {
  std::string pattern;
  std::string text;
  bool want;
};

class PatternTest : public testing::TestWithParam<Case> {};

TEST_P(PatternTest, Matches) {
  const auto matches = MatchesPattern(GetParam().text, GetParam().pattern);
  ASSERT_TRUE(matches.ok()) << matches.status();
  EXPECT_EQ(*matches, GetParam().want) << GetParam().pattern << " on " << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Patterns, PatternTest,
    testing::Values(Case{"", "", true}, Case{"", "a", false}, Case{"abc", "abc", true},
                    Case{"abc", "xabcx", false}, Case{".*MK3.*", "PRINTER_MODEL_MK3S", true},
                    Case{".*MK3.*", "PRINTER_MODEL_MK2", false},
                    Case{".*(MK3|MINI).*", "a MINI b", true}, Case{"a?b+c*", "bb", true},
                    Case{"a?b+c*", "aab", false}, Case{"(ab)*", "ababab", true},
                    Case{"(ab)*", "aba", false}, Case{"(?:a|b|)c", "c", true},
                    Case{"[a-c]+", "cab", true}, Case{"[^a-c]+", "dad", false},
                    Case{"[]x]+", "]x", true}, Case{"[a-]+", "-a", true},
                    Case{"\\d+\\.\\d", "12.5", true}, Case{"\\w\\s\\W", "a !", true},
                    Case{"^a$", "a", true}, Case{"[\\d.]+", "1.5", true}, Case{"a.c", "a\nc", true},
                    Case{".*MODEL_MK3.*", "keep\nMODEL_MK3\n", true},
                    // ^ and $ match at each line, as in PrusaSlicer's notes.
                    Case{".*^MODEL_MK3$.*", "keep\nMODEL_MK3\n", true},
                    Case{".*^MODEL_MK3$.*", "keep MODEL_MK3\n", false}, Case{"a^b", "ab", false},
                    Case{"mk3", "MK3", false}, Case{"(?i)mk3", "MK3", true},
                    Case{"a{2,3}", "aaa", true}, Case{"a{2,3}", "aaaa", false},
                    Case{"\\bMK3\\b.*", "MK3 S", true}, Case{"[[:digit:]]+", "17", true},
                    Case{"a.*?b", "a b b", true}, Case{"\xc3.", "\xc3\xa9", true},
                    Case{".", "\xc3\xa9", false}, Case{"..", "\xff\xfe", true}));

class BadPatternTest : public testing::TestWithParam<std::string> {};

TEST_P(BadPatternTest, IsRefused) {
  EXPECT_EQ(MatchesPattern("a", GetParam()).status().code(), absl::StatusCode::kInvalidArgument);
}

INSTANTIATE_TEST_SUITE_P(Patterns, BadPatternTest,
                         testing::Values("(", ")", "a)", "(a", "[a", "*", "a|*", "\\",
                                         std::string(1'001, 'a'), std::string(100, '('), "(a)\\1",
                                         "(?=a)a", "a{1001}", "((a{100}){100}){100}", "a**",
                                         "[b-a]"));

TEST(MatchesPattern, AgreesWithTheStandardLibrary) {
  std::mt19937 random(4);
  const std::vector<std::string> atoms = {"a", "b", ".", "[ab]", "[^a]", "(a|b)", "(ab)", "(a*b)"};
  const std::vector<std::string> repeats = {"", "", "*", "+", "?"};
  for (int i = 0; i < 2'000; ++i) {
    std::string pattern;
    std::string text;
    for (size_t k = random() % 5; k-- > 0;) {
      pattern += atoms[random() % atoms.size()] + repeats[random() % repeats.size()];
      if (random() % 6 == 0) pattern += "|";
    }
    for (size_t k = random() % 6; k-- > 0;) text += static_cast<char>('a' + random() % 3);
    const auto matches = MatchesPattern(text, pattern);
    ASSERT_TRUE(matches.ok()) << pattern;
    ASSERT_EQ(*matches, std::regex_match(text, std::regex(pattern))) << pattern << " on " << text;
  }
}

// Patterns for which a backtracking matcher would make 2^n attempts.
TEST(MatchesPattern, HostilePatternsEnd) {
  const std::string text(2'000, 'a');
  EXPECT_FALSE(*MatchesPattern(text + "b", "(a|a)*(a*)*(a+)+c"));
  EXPECT_TRUE(*MatchesPattern(text, "((a*)*)*"));
  // An automaton with more states than the memory limit allows.
  EXPECT_TRUE(*MatchesPattern(text, "(a|b)*a(a|b){12}"));
  EXPECT_FALSE(*MatchesPattern(text + "c", "(a|b)*a(a|b){12}"));
}

}  // namespace
}  // namespace slicefarm::macro::regex_test
