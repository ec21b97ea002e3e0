#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/macro/template.h"

namespace slicefarm::macro::template_parser_test {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Not;

struct BadCase {
  std::string name;
  std::string text;
  std::string line;
};

class BadFormTest : public testing::TestWithParam<BadCase> {};

TEST_P(BadFormTest, IsRefusedWithItsPlace) {
  const auto code = ParseTemplate("end_gcode", GetParam().text);
  ASSERT_FALSE(code.ok());
  const ErrorDetail detail = DetailOf(code.status());
  EXPECT_EQ(detail.reason, Reason::kSettingMalformed);
  EXPECT_EQ(detail.metadata.at("setting"), "end_gcode");
  EXPECT_EQ(detail.metadata.at("line"), GetParam().line) << code.status();
}

INSTANTIATE_TEST_SUITE_P(
    Templates, BadFormTest,
    testing::Values(BadCase{"OpenBracket", "\n\nG28\n[temperature", "4"},
                    BadCase{"OpenBrace", "{temperature", "1"}, BadCase{"NoName", "[1 + 1]", "1"},
                    BadCase{"EmptyBrace", "{}", "1"}, BadCase{"NoEndif", "{if true}\nx", "2"},
                    BadCase{"EndifAlone", "{endif}", "1"}, BadCase{"ElseAlone", "{else}", "1"},
                    BadCase{"ElseTwice", "{if true}{else}{else}{endif}", "1"},
                    BadCase{"ElsifAfterElse", "{if true}{else}{elsif true}{endif}", "1"},
                    BadCase{"TwoExpressions", "{1 2}", "1"}, BadCase{"Half", "{1 +}", "1"},
                    BadCase{"OpenParenthesis", "{(1}", "1"}, BadCase{"OpenText", "{\"open}", "1"},
                    BadCase{"OpenIndex", "{temperature[}", "1"},
                    BadCase{"OneArgument", "{min(1)}", "1"}, BadCase{"HalfTernary", "{1 ? 2}", "1"},
                    BadCase{"Dollar", "{$x}", "1"}, BadCase{"Assigned", "{1 = 2}", "1"},
                    BadCase{"PatternAsText", "{\"a\" =~ \"a\"}", "1"},
                    BadCase{"OpenPattern", "{\"a\" =~ /a}", "1"},
                    BadCase{"Huge", "{99999999999999999999e999}", "1"},
                    BadCase{"UnknownFunction", "{system(1)}", "1"},
                    BadCase{"WordAsName", "{local if = 1}", "1"},
                    BadCase{"FunctionAlone", "{min}", "1"},
                    BadCase{"NilOfValue", "{is_nil(1)}", "1"},
                    BadCase{"TableOfNothing", "{interpolate_table(1, )}", "1"},
                    BadCase{"DeepParentheses", "{" + std::string(5'000, '(') + "1}", "1"},
                    BadCase{"DeepMinus", "{" + std::string(5'000, '-') + "1}", "1"},
                    BadCase{"DeepNot", "{" + std::string(5'000, '!') + "true}", "1"},
                    BadCase{"DeepBraces", std::string(60'000, '{'), "1"}),
    [](const auto& info) { return info.param.name; });

TEST(ParseTemplate, DepthIsBounded) {
  const auto nested = [](int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i) text += "{if true}";
    text += "x";
    for (int i = 0; i < depth; ++i) text += "{endif}";
    return text;
  };
  EXPECT_TRUE(ParseTemplate("g", nested(100)).ok());
  EXPECT_FALSE(ParseTemplate("g", nested(10'000)).ok());
  std::string terms = "{1";
  for (int i = 0; i < 10'000; ++i) terms += "+1";
  EXPECT_TRUE(ParseTemplate("g", terms + "}").ok());
}

TEST(NamesIn, AreThoseOfVariablesAndFunctions) {
  const auto code = ParseTemplate(
      "g", "[a_2] [b[c]] {if d[e] == \"f\"}{local h = max(i, 1)}{else}{random(1, 2)}{endif}");
  ASSERT_TRUE(code.ok()) << code.status();
  const std::set<std::string> names = NamesIn(*code);
  for (const char* name : {"a", "a_2", "b", "c", "d", "e", "h", "i", "random"})
    EXPECT_THAT(names, Contains(name));
  EXPECT_THAT(names, Not(Contains("f")));
}

TEST(GlobalsOf, AreThoseThatAreMade) {
  const auto code = ParseTemplate("g", "{global a = 1; local b = 2}{if a}{global c = 1}{endif}");
  ASSERT_TRUE(code.ok()) << code.status();
  EXPECT_THAT(GlobalsOf(*code), ElementsAre("a", "c"));
}

}  // namespace
}  // namespace slicefarm::macro::template_parser_test
