#include "common/macro/template_run.h"

#include <gtest/gtest.h>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::macro::template_run_test {
namespace {

TemplateVariable Whole(std::vector<int64_t> items) {
  std::vector<TemplateValue> values(items.begin(), items.end());
  return TemplateVariable::List(std::move(values));
}

const TemplateVariables& Variables() {
  static const auto& variables = *new TemplateVariables{
      {"first_layer_temperature", int64_t{215}},
      {"temperature", Whole({210, 205})},
      {"speeds", TemplateVariable::List({1.5, 2.0})},
      {"bed_temperature", int64_t{60}},
      {"layer_num", int64_t{2}},
      {"layer_z", 0.6},
      {"initial_extruder", int64_t{1}},
      {"filament_type", TemplateVariable::List({std::string("PETG")})},
      {"current_extruder", int64_t{0}},
      {"wipe", true},
      {"open", TemplateVariable::List({Nil{}, int64_t{3}})},
      {"nothing", TemplateVariable::List({})},
      {"position", TemplateVariable::List({0.0, 0.0, 0.0})},
      {"pressure_advance", 0.04},
  };
  return variables;
}

struct Case {
  std::string name;
  std::string text;
  std::string want;
};

class TemplateTest : public testing::TestWithParam<Case> {};

TEST_P(TemplateTest, Expands) {
  const auto text = ExpandTemplate("start_gcode", GetParam().text, Variables());
  ASSERT_TRUE(text.ok()) << text.status();
  EXPECT_EQ(*text, GetParam().want);
}

const auto kCaseName = [](const auto& info) { return info.param.name; };

INSTANTIATE_TEST_SUITE_P(
    Text, TemplateTest,
    testing::Values(
        Case{"Empty", "", ""}, Case{"Plain", "G28 ; home\nG1 Z5", "G28 ; home\nG1 Z5"},
        Case{"BlanksBefore", "\n  G28\n", "G28\n"}, Case{"BraceAlone", "a } b ] c", "a } b ] c"},
        Case{"Bracket", "M104 S[first_layer_temperature]", "M104 S215"},
        Case{"BracketElement", "M104 S[temperature_1] [temperature_7]", "M104 S205 210"},
        Case{"BracketIndex", "M104 S[temperature[current_extruder]]", "M104 S210"},
        Case{"BracketOpenIndex", "M104 S[temperature_[initial_extruder]]", "M104 S205"},
        Case{"BracketOfLocal", "{local a = 7}[a]", "7"},
        Case{"Brace", "M104 S{first_layer_temperature[0]}", "M104 S215"},
        Case{"BraceIndex", "{temperature[current_extruder] - 10}", "200"},
        Case{"Layer", ";[layer_num] {layer_z}", ";2 0.6"}, Case{"BraceInText", "{\"}{\"}", "}{"},
        Case{"Semicolons", "{1;2;;3}{;}", "123"}),
    kCaseName);

INSTANTIATE_TEST_SUITE_P(
    If, TemplateTest,
    testing::Values(
        Case{"If", "{if layer_num == 2}A{endif}B", "AB"},
        Case{"IfNot", "{if layer_num == 3}A{endif}B", "B"},
        Case{"Else", "{if layer_num == 3}A{else}B{endif}", "B"},
        Case{"Elsif", "{if layer_num==1}A{elsif layer_num==2}B{elsif true}C{else}D{endif}", "B"},
        Case{"ElsifAfterChoice", "{if true}A{elsif true}B{else}C{endif}", "A"},
        Case{"Nested", "{if true}1{if false}2{else}3{endif}4{else}5{endif}", "134"},
        Case{"NestedInFalse", "{if false}1{if true}2{else}3{endif}4{endif}5", "5"},
        Case{"UnknownInFalse", "{if false}[nowhere]{nowhere + 1}{endif}ok", "ok"},
        Case{"Lines", "{if filament_type[0] == \"PETG\"}\nM106 S0\n{endif}\n", "\nM106 S0\n\n"},
        Case{"Blanks", "{ if true }x{ endif }", "x"},
        Case{"Then", "{if layer_num == 2 then \"a\" else \"b\" endif}", "a"},
        Case{"ThenElsif", "{if false then 1; elsif true then 2;3 else 4 endif}", "23"},
        Case{"ThenNested", "{if true then if false then 1 else 2 endif 3 endif}", "23"},
        Case{"CodeAfterEndif", "{if true}a{endif; 1; 2}", "a12"},
        Case{"ThenInText", "{if true}a{if false then \"b\" else \"c\" endif}d{endif}", "acd"},
        Case{"NamesLikeWords", "{local iffy = 1; local end = 2; local elsewhere = 3}{iffy + end}",
             "3"}),
    kCaseName);

INSTANTIATE_TEST_SUITE_P(
    Variables, TemplateTest,
    testing::Values(
        Case{"Local", "{local a = 5}M104 S{a + 1}", "M104 S6"},
        Case{"LocalAgain", "{local a = 5; local a = 6}{a}", "6"},
        Case{"KeepsItsType", "{local a = 5; a = 2.7}{a}", "2"},
        Case{"RealStaysReal", "{local a = 1.5; a = 3}{a / 2}", "1.5"},
        Case{"TextTakesAll", "{local a = \"x\"; a = 3}{a + 1}", "31"},
        Case{"OverASettingsName", "{local pressure_advance = 0.0}{pressure_advance}", "0"},
        Case{"InIf", "{local a = 1}{if true}{a = 2}{endif}{a}", "2"},
        Case{"List", "{local a = (1, 2, 3)}{a[2]}{size(a)}", "33"},
        Case{"ListOfOne", "{local a = (7)}{a[0]} {size(a)}", "7 1"},
        Case{"ListItem", "{local a = (1, 2); a[1] = 9}{a[1]}", "9"},
        Case{"ListMixed", "{local a = (1, 2.5); a[0] = 3}{a[0] / 2}", "1.5"},
        Case{"ListOfTexts", "{local a = (1, \"b\", 2.5)}{a[0] + a[2]}", "12.5"},
        Case{"Copy", "{local a = temperature; a[0] = 1}{a[0]} {temperature[0]}", "1 210"},
        Case{"Repeat", "{local a = repeat(3, 7)}{a[2]}{size(a)}", "73"},
        Case{"RepeatInto", "{local a = (1); a = repeat(2, 4)}{a[1]}", "4"},
        Case{"EmptyInto", "{local a = (1); a = ()}{empty(a)}", "true"},
        Case{"NotAList", "{local a = (1 + 2) * 3}{a}", "9"},
        Case{"Global", "{global a = 5}{a = a + 1}{a}", "6"},
        Case{"Output", "{position[2] = 5}{position[2]}", "5"}),
    kCaseName);

INSTANTIATE_TEST_SUITE_P(
    Functions, TemplateTest,
    testing::Values(
        Case{"IsNil", "{is_nil(open[0])} {is_nil(open[1])} {is_nil(layer_z)}", "true false false"},
        Case{"EmptySize", "{empty(nothing)} {empty(temperature)} {size(temperature)}",
             "true false 2"},
        Case{"OneOf", "{one_of(filament_type[0], \"PLA\", \"PETG\")}", "true"},
        Case{"OneOfNone", "{one_of(\"ABS\", \"PLA\", \"PETG\")} {one_of(\"x\")}", "false false"},
        Case{"OneOfPatterns", "{one_of(\"PETG\", /A.*/, ~\"PET.\")}", "true"},
        Case{"OneOfWithoutCommas", "{one_of(\"b\", \"a\" \"b\")}", "true"},
        Case{"Table", "{interpolate_table(2, (0, 0), (4, 8), (8, 0))}", "4"},
        Case{"TableEnds",
             "{interpolate_table(0, (0, 5), (4, 8))} {interpolate_table(4, (0, 5), (4, 8))}",
             "5 8"},
        Case{"TableWithoutCommas", "{interpolate_table(layer_z, (0,7000) (150,7000))}", "7000"},
        Case{"Digits", "{digits(5, 3)}|{zdigits(5, 3)}|{digits(2.5, 3)}|{zdigits(1.26, 6, 1)}",
             "  5|005|  3|0001.3"},
        Case{"DigitsClamped", "{digits(5, -3)}", "5"},
        Case{"MinMax", "{min(3, max(1, 2))} {max(2, 1.5) / 4}", "2 0.5"},
        Case{"IntRound", "{int(2.9) + round(2.5)} {int(-1.7)} {round(-1.7)}", "5 -1 -2"},
        Case{"Random", "{local a = random(3, 3)}{a} {random(0, 9) < 10} {random(0.0, 1.0) < 1}",
             "3 true true"}),
    kCaseName);

struct Term {
  std::string expression;
  std::string want;
};

class ExpressionTest : public testing::TestWithParam<Term> {};

TEST_P(ExpressionTest, ComesTo) {
  const auto text = ExpandTemplate("g", "{" + GetParam().expression + "}", Variables());
  ASSERT_TRUE(text.ok()) << GetParam().expression << ": " << text.status();
  EXPECT_EQ(*text, GetParam().want) << GetParam().expression;
}

INSTANTIATE_TEST_SUITE_P(
    Expressions, ExpressionTest,
    testing::Values(
        Term{"12", "12"}, Term{" .5 ", "0.5"}, Term{"1e3", "1000"}, Term{"\"a\\\"b\\n\"", "a\"b\n"},
        Term{"temperature", "210"}, Term{"temperature[1]", "205"}, Term{"temperature[9]", "210"},
        Term{"temperature[initial_extruder]", "205"}, Term{"temperature[0] + 5 * 2", "220"},
        Term{"(temperature[0] + 5) * 2", "430"}, Term{"-temperature", "-210"}, Term{"- -3", "3"},
        Term{"+3", "3"}, Term{"1 - +2", "-1"}, Term{"10 - 3 - 2", "5"}, Term{"7 / 2", "3"},
        Term{"7 / 2.0", "3.5"}, Term{"7 % 4", "3"}, Term{"7.5 % 2", "1.5"},
        Term{"layer_z > 0.5", "true"}, Term{"layer_z<=0.5", "false"},
        Term{"0.1 + 0.2 == 0.3", "true"}, Term{"layer_num == 2 and layer_z < 1", "true"},
        Term{"layer_num==1||wipe", "true"}, Term{"not wipe", "false"},
        Term{"!wipe or true", "true"}, Term{"!(1 == 2)", "true"}, Term{"1 != 2", "true"},
        Term{"1 <> 2", "true"}, Term{"!wipe == false", "true"},
        Term{"filament_type[0] == \"PETG\" ? 80 : 60", "80"},
        Term{"layer_num > 5 ? 1 : layer_num > 1 ? 2 : 3", "2"}, Term{"\"T\" + layer_num", "T2"},
        Term{"filament_type[0] =~ /PET.*/", "true"}, Term{"filament_type[0] !~ /PET/", "true"},
        Term{"\"a/b\" =~ /a\\/b/ and \"a.\" =~ /a\\./", "true"},
        // Parts that are not selected are not evaluated.
        Term{"true or unknown", "true"}, Term{"false and 1 / 0", "false"},
        Term{"true ? 1 : unknown", "1"}, Term{"false ? 1 / 0 : 2", "2"}));

struct BadCase {
  std::string name;
  std::string text;
  std::string line;
  std::string variable;
};

class BadTemplateTest : public testing::TestWithParam<BadCase> {};

TEST_P(BadTemplateTest, IsRefusedWithItsPlace) {
  const auto text = ExpandTemplate("end_gcode", GetParam().text, Variables());
  ASSERT_FALSE(text.ok());
  const ErrorDetail detail = DetailOf(text.status());
  EXPECT_EQ(detail.reason, Reason::kSettingMalformed);
  EXPECT_EQ(detail.metadata.at("setting"), "end_gcode");
  EXPECT_EQ(detail.metadata.at("line"), GetParam().line) << text.status();
  const auto variable = detail.metadata.find("variable");
  EXPECT_EQ(variable == detail.metadata.end() ? "" : variable->second, GetParam().variable);
}

INSTANTIATE_TEST_SUITE_P(
    Templates, BadTemplateTest,
    testing::Values(BadCase{"Unknown", "G28\nM104 S[nozzle]", "2", "nozzle"},
                    BadCase{"UnknownInBrace", "G28\n\n{if nozzle[0] > 1}x{endif}", "3", "nozzle"},
                    BadCase{"UnknownAssigned", "{nowhere = 1}", "1", "nowhere"},
                    BadCase{"Setting", "{bed_temperature = 1}", "1", ""},
                    BadCase{"IsNil", "{is_nil(nowhere)}", "1", "nowhere"},
                    BadCase{"NilRead", "{open[0]}", "1", "open"},
                    BadCase{"ElementOfNothing", "[nothing_0]", "1", "nothing_0"},
                    BadCase{"OutOfTable", "{interpolate_table(9, (0, 1), (1, 2))}", "1", ""},
                    BadCase{"TableFalls", "{interpolate_table(9, (1, 1), (0, 2))}", "1", ""},
                    BadCase{"NotBoth", "{local a = 1; global a = 1}", "1", ""},
                    BadCase{"ListIntoOne", "{local a = 1; a = (1, 2)}", "1", ""},
                    BadCase{"BeyondAList", "{local a = (1, 2); a[2] = 1}", "1", ""},
                    BadCase{"NoTypeOfAList", "{local a = ()}", "1", ""},
                    BadCase{"TruthInNumbers", "{local a = (1, true)}", "1", ""},
                    BadCase{"RandomWithoutRange", "{random(2, 1)}", "1", ""},
                    BadCase{"SizeOfNumber", "{size(layer_z)}", "1", ""},
                    BadCase{"DivisionByZero", "{1 / 0}", "1", ""}),
    kCaseName);

TEST(RunTemplate, GlobalsLiveOverTemplates) {
  TemplateMemory memory;
  const TemplateVariables job, now;
  const auto run = [&](std::string_view text) {
    const auto code = ParseTemplate("g", text);
    EXPECT_TRUE(code.ok()) << code.status();
    return RunTemplate(*code, {job, now}, memory).value_or("error");
  };
  EXPECT_EQ(run("{global count = 1; local here = 2}"), "");
  EXPECT_EQ(run("{count = count + 1}{count}"), "2");
  EXPECT_EQ(run("{here}"), "error");
  EXPECT_EQ(run("{global count = 7}{count}"), "7");
}

TEST(RunTemplate, RandomNumbersAreTheSameForEachJobAndGoOn) {
  TemplateMemory one, other;
  const TemplateVariables none;
  const auto code = ParseTemplate("g", "{random(0, 1000000)} {random(0, 1000000)}");
  const auto first = RunTemplate(*code, {none, none}, one);
  EXPECT_EQ(*first, *RunTemplate(*code, {none, none}, other));
  EXPECT_NE(*first, *RunTemplate(*code, {none, none}, one));
}

struct Check {
  std::string name;
  std::string text;
  std::string variable;  ///< variable that the error names; "-": no error
};

class CheckTemplateTest : public testing::TestWithParam<Check> {};

// `seen`: a variable that only the print determines.
TEST_P(CheckTemplateTest, LooksWherePrintsMayGo) {
  const TemplateVariables now = {{"seen", Unknown{}}};
  TemplateMemory memory;
  const auto code = ParseTemplate("g", GetParam().text);
  ASSERT_TRUE(code.ok()) << code.status();
  const absl::Status status = CheckTemplate(*code, {Variables(), now}, memory);
  EXPECT_EQ(status.ok(), GetParam().variable == "-") << status;
  if (status.ok()) return;
  const auto metadata = DetailOf(status).metadata;
  EXPECT_EQ(metadata.contains("variable") ? metadata.at("variable") : "", GetParam().variable);
}

INSTANTIATE_TEST_SUITE_P(
    Checks, CheckTemplateTest,
    testing::Values(
        Check{"Fine", "{seen + 1} {layer_num}", "-"},
        Check{"EitherWay", "{if seen > 1}a{elsif seen > 2}[oops]{endif}", "oops"},
        Check{"Else", "{if seen > 1}a{else}[oops]{endif}", "oops"},
        Check{"NotTaken", "{if layer_num == 1 and seen > 1}[oops]{endif}", "-"},
        Check{"Ternary", "{seen == 1 ? 1 : oops}", "oops"},
        Check{"RightOfUnknown", "{if seen == 1 or oops}a{endif}", "oops"},
        Check{"Decided", "{if seen == 1 or true}a{else}[oops]{endif}", "-"},
        Check{"ChangedMaybe",
              "{local a = 1}{if seen == 1}{a = 2}{endif}{if a == 1}x{else}[oops]{endif}", "oops"},
        Check{"MadeMaybe", "{if seen == 1}{local a = 2}{endif}{if true}{a}{endif}", "-"},
        Check{"DividesByUnknown", "{1 / seen}", "-"},
        Check{"DividesByZero", "{if seen == 1}{1 / 0}{endif}", ""},
        Check{"UnknownIndex", "{temperature[seen]} [temperature[seen]] {oops[seen]}", "oops"}),
    kCaseName);

TEST(ExpandTemplate, WhatComesOutIsBounded) {
  const TemplateVariables variables = {{"notes", std::string(limits::kMaxSettingBytes, 'n')}};
  std::string printed, joined = "{if notes";
  for (int i = 0; i < 9'000; ++i) {
    printed += "[notes]";
    joined += "+notes";
  }
  joined += " == \"\"}{endif}";
  for (const std::string& text : {printed, joined}) {
    const ErrorDetail detail = DetailOf(ExpandTemplate("layer_gcode", text, variables).status());
    EXPECT_EQ(detail.reason, Reason::kRequestTooLarge);
    EXPECT_EQ(detail.metadata.at("setting"), "layer_gcode");
    EXPECT_EQ(detail.metadata.at("limit"), std::to_string(limits::kMaxExpandedBytes));
  }
  EXPECT_TRUE(ExpandTemplate("layer_gcode", "[notes]{notes + notes}", variables).ok());
  EXPECT_TRUE(ExpandTemplate("layer_gcode", "{if false}" + printed + "{endif}", variables).ok());
}

/// An expression of any length does not exhaust the stack.
TEST(ExpandTemplate, LongExpressionsEnd) {
  for (const char* joint : {"+1", " and true", " or false", "*1", "==1"}) {
    std::string text = std::string(joint)[0] == ' ' ? "{true" : "{1";
    while (text.size() < 60'000) text += joint;
    (void)ExpandTemplate("g", text + "}", {});
  }
  std::string sum = "{0";
  for (int i = 0; i < 30'000; ++i) sum += "+1";
  EXPECT_EQ(*ExpandTemplate("g", sum + "}", {}), "30000");
}

/// Texts that double and lists with millions of items are stopped early.
TEST(ExpandTemplate, WhatItTakesIsBounded) {
  std::string doubling = "{local a = \"xxxxxxxxxxxxxxxx\"";
  for (int i = 0; i < 60; ++i) doubling += "; a = a + a";
  std::string lists = "{local a = repeat(100000, 1)";
  for (int i = 0; i < 1000; ++i) absl::StrAppend(&lists, "; local b", i, " = a");
  for (const std::string& text :
       {doubling + "}", lists + "}", std::string("{local a = repeat(1000000000, \"x\")}"),
        std::string("{local a = repeat(9223372036854775807, 1)}")}) {
    const ErrorDetail detail = DetailOf(ExpandTemplate("g", text, {}).status());
    EXPECT_TRUE(detail.metadata.contains("limit")) << text.substr(0, 60);
  }
}

}  // namespace
}  // namespace slicefarm::macro::template_run_test
