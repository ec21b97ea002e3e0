#include "services/motion/algo/macro/gcode_template.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::motion::gcode_template_test {
namespace {

const TemplateVariables& Variables() {
  static const auto& variables = *new TemplateVariables{
      {"first_layer_temperature", {int64_t{215}}},
      {"temperature", {int64_t{210}, int64_t{205}}},
      {"bed_temperature", {int64_t{60}}},
      {"layer_num", {int64_t{2}}},
      {"layer_z", {0.6}},
      {"filament_type", {std::string("PETG")}},
      {"current_extruder", {int64_t{0}}},
      {"nothing", {}},
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

INSTANTIATE_TEST_SUITE_P(
    Templates, TemplateTest,
    testing::Values(
        Case{"Empty", "", ""}, Case{"Plain", "G28 ; home\nG1 Z5", "G28 ; home\nG1 Z5"},
        Case{"Bracket", "M104 S[first_layer_temperature]", "M104 S215"},
        Case{"BracketElement", "M104 S[temperature_1] [temperature_7]", "M104 S205 210"},
        Case{"BracketIndex", "M104 S[temperature[current_extruder]]", "M104 S210"},
        Case{"Brace", "M104 S{first_layer_temperature[0]}", "M104 S215"},
        Case{"BraceIndex", "{temperature[current_extruder] - 10}", "200"},
        Case{"Layer", ";[layer_num] {layer_z}", ";2 0.6"},
        Case{"If", "{if layer_num == 2}A{endif}B", "AB"},
        Case{"IfNot", "{if layer_num == 3}A{endif}B", "B"},
        Case{"Else", "{if layer_num == 3}A{else}B{endif}", "B"},
        Case{"Elsif", "{if layer_num==1}A{elsif layer_num==2}B{elsif true}C{else}D{endif}", "B"},
        Case{"ElsifAfterChoice", "{if true}A{elsif true}B{else}C{endif}", "A"},
        Case{"Nested", "{if true}1{if false}2{else}3{endif}4{else}5{endif}", "134"},
        Case{"NestedInFalse", "{if false}1{if true}2{else}3{endif}4{endif}5", "5"},
        Case{"UnknownInFalse", "{if false}[nowhere]{nowhere + 1}{endif}ok", "ok"},
        Case{"BraceInText", "{\"}{\"}", "}{"},
        Case{"Lines", "{if filament_type == \"PETG\"}\nM106 S0\n{endif}\n", "\nM106 S0\n\n"},
        Case{"CommentAfterIf", "{ if true }x{ endif }", "x"}),
    [](const auto& info) { return info.param.name; });

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
  EXPECT_EQ(detail.metadata.at("line"), GetParam().line);
  const auto variable = detail.metadata.find("variable");
  EXPECT_EQ(variable == detail.metadata.end() ? "" : variable->second, GetParam().variable);
}

INSTANTIATE_TEST_SUITE_P(
    Templates, BadTemplateTest,
    testing::Values(BadCase{"Unknown", "G28\nM104 S[nozzle]", "2", "nozzle"},
                    BadCase{"UnknownInBrace", "\n\n{if nozzle[0] > 1}", "3", "nozzle"},
                    BadCase{"ElementOfNothing", "[nothing_0]", "1", "nothing_0"},
                    BadCase{"OpenBracket", "[temperature", "1", ""},
                    BadCase{"OpenBrace", "{temperature", "1", ""},
                    BadCase{"NoName", "[1 + 1]", "1", ""}, BadCase{"EmptyBrace", "{}", "1", ""},
                    BadCase{"NoEndif", "{if true}\nx", "2", ""},
                    BadCase{"EndifAlone", "{endif}", "1", ""},
                    BadCase{"ElseAlone", "{else}", "1", ""},
                    BadCase{"ElseTwice", "{if true}{else}{else}{endif}", "1", ""},
                    BadCase{"ElsifAfterElse", "{if true}{else}{elsif true}{endif}", "1", ""},
                    BadCase{"DivisionByZero", "{1 / 0}", "1", ""}),
    [](const auto& info) { return info.param.name; });

TEST(ExpandTemplate, LongAndDeepInputEnds) {
  std::string deep;
  for (int i = 0; i < 10'000; ++i) deep += "{if true}";
  deep += "x";
  for (int i = 0; i < 10'000; ++i) deep += "{endif}";
  EXPECT_EQ(*ExpandTemplate("start_gcode", deep, Variables()), "x");
  EXPECT_FALSE(ExpandTemplate("start_gcode", std::string(60'000, '{'), Variables()).ok());
}

/// A short name may stand for a long text.
TEST(ExpandTemplate, WhatComesOutIsBounded) {
  const TemplateVariables variables = {{"notes", {std::string(limits::kMaxSettingBytes, 'n')}}};
  std::string printed, joined = "{if notes";
  for (int i = 0; i < 9'000; ++i) {
    printed += "[notes]";
    joined += "+notes";
  }
  joined += " == \"\"}{endif}";
  for (const std::string& text : {printed, joined}) {
    const ErrorDetail detail = DetailOf(ExpandTemplate("layer_gcode", text, variables).status());
    EXPECT_EQ(detail.reason, Reason::kSettingMalformed);
    EXPECT_EQ(detail.metadata.at("setting"), "layer_gcode");
    EXPECT_EQ(detail.metadata.at("limit"), std::to_string(limits::kMaxExpandedBytes));
  }
  EXPECT_TRUE(ExpandTemplate("layer_gcode", "[notes]{notes + notes}", variables).ok());
  EXPECT_TRUE(ExpandTemplate("layer_gcode", "{if false}" + printed + "{endif}", variables).ok());
}

}  // namespace
}  // namespace slicefarm::motion::gcode_template_test
