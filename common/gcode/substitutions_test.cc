#include "common/gcode/substitutions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace slicefarm::gcode::substitutions_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr size_t kMuch = 1 << 20;

TEST(Substitutions, ReplaceAsPrusaSlicerDoes) {
  struct Case {
    const char* name;
    std::vector<std::string> items;
    const char* gcode;
    const char* want;
  };
  const Case cases[] = {
      {"plain", {"M204", "M205", "", ""}, "M204 P1\nM204 P2\n", "M205 P1\nM205 P2\n"},
      {"plain text is no pattern", {"E.", "x", "", "note"}, "E.1 E1\n", "x1 E1\n"},
      {"backslashes stay", {"a", "b\\\\1", "", ""}, "a\n", "b\\1\n"},
      {"line ends in both", {"M1\\n", "M2\\n;\\tx\\n", "", ""}, "M1\nM1 S\n", "M2\n;\tx\nM1 S\n"},
      {"case", {"m204", "X", "i", ""}, "M204 m204\n", "X X\n"},
      {"case counts", {"m204", "X", "", ""}, "M204 m204\n", "M204 X\n"},
      {"whole words", {"M20", "X", "w", ""}, "M20 M204 aM20\n", "X M204 aM20\n"},
      {"groups", {"(M)(20.)", "$2$1 \\1", "r", ""}, "M204\n", "204M M\n"},
      {"the whole match", {"G1.*", ";$&", "r", ""}, "G1 X1\nG1 Y1\n", ";G1 X1\n;G1 Y1\n"},
      {"ends of lines", {"^;.*$", "", "r", ""}, ";a\nG1 ;b\n", "\nG1 ;b\n"},
      {"a dot is no line end", {"a.*b", "x", "r", ""}, "a\nb\n", "a\nb\n"},
      {"but with s", {"a.*b", "x", "rs", ""}, "a\nb\n", "x\n"},
      {"several, one after the other", {"a", "b", "", "", "b", "c", "", ""}, "ab\n", "cc\n"},
      {"nothing to look for", {"", "x", "", ""}, "ab\n", "ab\n"},
      {"a dollar that is none", {"a", "$", "r", ""}, "a\n", "$\n"},
  };
  for (const Case& c : cases) {
    const auto substitutions = Substitutions::Of(c.items);
    ASSERT_TRUE(substitutions.ok()) << c.name << substitutions.status();
    EXPECT_EQ(*substitutions->Apply(c.gcode, kMuch, CancelToken()), c.want) << c.name;
  }
}

TEST(Substitutions, WhatCannotBeDoneIsRefused) {
  struct Case {
    std::vector<std::string> items;
    const char* why;
  };
  const Case cases[] = {{{"a", "b", ""}, "four texts"},
                        {{"(", "b", "r", ""}, "missing"},
                        {{"(a)", "$2", "r", ""}, "Rewrite schema requests 2"},
                        {{"(?=a)b", "", "r", ""}, "invalid perl operator"},
                        {{"((a{100}){100}){100}", "", "r", ""}, "repetition size"}};
  for (const Case& c : cases)
    EXPECT_THAT(std::string(Substitutions::Of(c.items).status().message()), HasSubstr(c.why));
}

TEST(Substitutions, NoBacktracking) {
  const auto slow = Substitutions::Of({"(a*)*b", "x", "r", ""});
  ASSERT_TRUE(slow.ok());
  const std::string text(100'000, 'a');
  EXPECT_EQ(*slow->Apply(text, kMuch, CancelToken()), text);
}

TEST(Substitutions, GrowthEndsAtTheBound) {
  std::vector<std::string> doubling;
  for (int i = 0; i < 24; ++i) doubling.insert(doubling.end(), {".+", "$&$&", "rs", ""});
  const std::string line = "G1 X1 Y1 E1\n";
  std::string many_lines;
  for (int i = 0; i < 1000; ++i) many_lines += line;
  struct Case {
    const char* name;
    std::vector<std::string> items;
    std::string gcode;
  };
  const Case cases[] = {
      {"rules that double", doubling, line},
      {"one rule with a long text", {"^G1", std::string(60'000, 'x'), "r", ""}, many_lines},
      {"an empty pattern", {"x*", std::string(60'000, 'y'), "r", ""}, many_lines},
  };
  for (const Case& c : cases) {
    const auto substitutions = Substitutions::Of(c.items);
    ASSERT_TRUE(substitutions.ok()) << c.name << substitutions.status();
    const auto grown = substitutions->Apply(c.gcode, 1 << 20, CancelToken());
    EXPECT_TRUE(absl::IsResourceExhausted(grown.status())) << c.name << grown.status();
  }
}

TEST(Substitutions, AreCancelledBetweenMatches) {
  const auto substitutions = Substitutions::Of({"a", "b", "", ""});
  int polls = 0;
  const CancelToken cancel([&] { return ++polls == 3; });
  const auto text = substitutions->Apply(std::string(100'000, 'a'), kMuch, cancel);
  EXPECT_TRUE(absl::IsCancelled(text.status())) << text.status();
  EXPECT_EQ(polls, 3);
}

TEST(Substitutions, EmptyMatchesKeepCharactersWhole) {
  const auto substitutions = Substitutions::Of({"q*", "-", "r", ""});
  EXPECT_EQ(*substitutions->Apply("\xC3\xA4z", kMuch, CancelToken()), "-\xC3\xA4-z-");
}

TEST(Substitutions, RulesAreCounted) {
  std::vector<std::string> items;
  for (size_t i = 0; i < Substitutions::kMostRules; ++i)
    items.insert(items.end(), {"a", "b", "", ""});
  EXPECT_TRUE(Substitutions::Of(items).ok());
  items.insert(items.end(), {"a", "b", "", ""});
  EXPECT_THAT(std::string(Substitutions::Of(items).status().message()),
              HasSubstr("65 rules, at most 64"));
}

TEST(TextsOfList, AreUnescaped) {
  EXPECT_THAT(TextsOfList(""), IsEmpty());
  EXPECT_THAT(TextsOfList(R"("a; \"b\"";c ; "\\n\n")"), ElementsAre("a; \"b\"", "c", "\\n\n"));
  EXPECT_THAT(TextsOfList(R"(a;"";"";)"), ElementsAre("a", "", "", ""));
  EXPECT_THAT(TextsOfList(R"("never ended)"), ElementsAre("never ended"));
}

}  // namespace
}  // namespace slicefarm::gcode::substitutions_test
