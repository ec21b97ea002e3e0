#include "services/slicing/algo/mesh_io/text_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace slicefarm::slicing::text_lines_test {
namespace {

using testing::ElementsAre;

TEST(Words, AreSeparatedByAnyBlanks) {
  Words words("  v\t1.5\r -2 \\\n3");
  EXPECT_EQ(words.Next(), "v");
  EXPECT_EQ(words.Next(), "1.5");
  EXPECT_EQ(words.Next(), "-2");
  EXPECT_EQ(words.Next(), "3");
  EXPECT_EQ(words.Next(), "");
  EXPECT_EQ(words.Next(), "");
}

struct NumberCase {
  std::string word;
  std::optional<double> want;
};

TEST(ParseNumber, GivesTheseValues) {
  const std::vector<NumberCase> cases = {
      {"0", 0.0},           {"-0.5", -0.5},        {"+2", 2.0},
      {"1e3", 1000.0},      {"1.5E-3", 0.0015},    {".25", 0.25},
      {"5.", 5.0},          {"1e-999", 0.0},       {"-1e-999", 0.0},
      {"", std::nullopt},   {"1,5", std::nullopt}, {"1.5mm", std::nullopt},
      {"+", std::nullopt},  {"+-1", std::nullopt}, {"0x10", std::nullopt},
      {"e5", std::nullopt}, {"--1", std::nullopt},
  };
  for (const NumberCase& c : cases) EXPECT_EQ(ParseNumber(c.word), c.want) << c.word;
  EXPECT_EQ(ParseNumber("0." + std::string(400, '0') + "1"), 0.0);
  EXPECT_TRUE(std::isinf(*ParseNumber("1e999")));
  EXPECT_TRUE(std::isinf(*ParseNumber("-inf")));
  EXPECT_TRUE(std::isnan(*ParseNumber("nan")));
}

std::vector<std::string> LinesOf(std::string_view text, bool joins = false) {
  LineReader reader(text, 20, joins);
  std::vector<std::string> lines;
  for (auto line = reader.Next(); line.ok() && line->has_value(); line = reader.Next())
    lines.push_back(std::to_string(reader.number()) + ":" + std::string(Words(**line).Next()));
  return lines;
}

TEST(LineReader, KnowsAllLineEnds) {
  EXPECT_THAT(LinesOf("a\nb\n"), ElementsAre("1:a", "2:b"));
  EXPECT_THAT(LinesOf("a\r\nb\r\nc"), ElementsAre("1:a", "2:b", "3:c"));
  EXPECT_THAT(LinesOf("a\rb\r\rc"), ElementsAre("1:a", "2:b", "3:", "4:c"));
  EXPECT_THAT(LinesOf("a\rb\r\nc\nd\r"), ElementsAre("1:a", "2:b", "3:c", "4:d"));
  EXPECT_THAT(LinesOf("a\n\rb\n"), ElementsAre("1:a", "2:", "3:b"));
  EXPECT_THAT(LinesOf(""), ElementsAre());
  EXPECT_THAT(LinesOf("\n"), ElementsAre("1:"));
}

TEST(LineReader, JoinsContinuedLinesAndKeepsCounting) {
  EXPECT_THAT(LinesOf("a \\\nb\nc", true), ElementsAre("1:a", "3:c"));
  EXPECT_THAT(LinesOf("a \\\r\nb\r\nc", true), ElementsAre("1:a", "3:c"));
  EXPECT_THAT(LinesOf("a \\\rb\rc", true), ElementsAre("1:a", "3:c"));
  EXPECT_THAT(LinesOf("a \\\nb\nc", false), ElementsAre("1:a", "2:b", "3:c"));
  EXPECT_THAT(LinesOf("a\\", true), ElementsAre("1:a"));
}

TEST(LineReader, RefusesLongLinesWithTheNumbers) {
  const std::string text = "short\n" + std::string(21, 'x') + "\n";
  LineReader reader(text, 20, false);
  ASSERT_TRUE(reader.Next().ok());
  const auto line = reader.Next();
  ASSERT_FALSE(line.ok());
  const ErrorDetail detail = DetailOf(line.status());
  EXPECT_EQ(detail.reason, Reason::kMeshMalformed);
  EXPECT_EQ(detail.metadata.at("line"), "2");
  EXPECT_EQ(detail.metadata.at("limit"), "20");
  EXPECT_EQ(detail.metadata.at("got"), "21");
}

TEST(LineReader, JoinedLinesCountTogether) {
  std::string text;
  for (int i = 0; i < 10; ++i) text += "abcdef\\\n";
  LineReader reader(text, 20, true);
  EXPECT_FALSE(reader.Next().ok());
}

}  // namespace
}  // namespace slicefarm::slicing::text_lines_test
