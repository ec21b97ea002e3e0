#include "services/motion/algo/macro/template_expression.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::template_expression_test {
namespace {

const TemplateVariables& Variables() {
  static const auto& variables = *new TemplateVariables{
      {"temperature", {int64_t{210}, int64_t{215}}},
      {"layer_z", {0.6}},
      {"layer_num", {int64_t{2}}},
      {"initial_extruder", {int64_t{1}}},
      {"filament_type", {std::string("PETG")}},
      {"wipe", {true}},
  };
  return variables;
}

struct Case {
  std::string expression;
  std::string want;
};

class ExpressionTest : public testing::TestWithParam<Case> {};

TEST_P(ExpressionTest, ComesTo) {
  const auto value = EvaluateExpression(GetParam().expression, Variables(), true);
  ASSERT_TRUE(value.ok()) << GetParam().expression << ": " << value.status();
  EXPECT_EQ(ToText(*value), GetParam().want) << GetParam().expression;
}

INSTANTIATE_TEST_SUITE_P(
    Expressions, ExpressionTest,
    testing::Values(
        Case{"12", "12"}, Case{" .5 ", "0.5"}, Case{"1e3", "1000"}, Case{"\"a\\\"b\"", "a\"b"},
        Case{"temperature", "210"}, Case{"temperature[1]", "215"}, Case{"temperature[9]", "210"},
        Case{"temperature[initial_extruder]", "215"}, Case{"temperature[0] + 5 * 2", "220"},
        Case{"(temperature[0] + 5) * 2", "430"}, Case{"-temperature", "-210"}, Case{"- -3", "3"},
        Case{"10 - 3 - 2", "5"}, Case{"7 / 2", "3"}, Case{"7 / 2.0", "3.5"}, Case{"7 % 4", "3"},
        Case{"layer_z > 0.5", "true"}, Case{"layer_z<=0.5", "false"},
        Case{"layer_num == 2 and layer_z < 1", "true"}, Case{"layer_num==1||wipe", "true"},
        Case{"not wipe", "false"}, Case{"!wipe or true", "true"}, Case{"!(1 == 2)", "true"},
        Case{"1 != 2", "true"}, Case{"1 <> 2", "true"}, Case{"not 1 == 2", "true"},
        Case{"filament_type == \"PETG\" ? 80 : 60", "80"},
        Case{"layer_num > 5 ? 1 : layer_num > 1 ? 2 : 3", "2"}, Case{"min(3, max(1, 2))", "2"},
        Case{"int(2.9) + round(2.5)", "5"}, Case{"zdigits(layer_num, 3)", "002"},
        Case{"\"T\" + layer_num", "T2"}, Case{"filament_type =~ /PET.*/", "true"},
        Case{"filament_type !~ /PET/", "true"},
        Case{"\"a/b\" =~ /a\\/b/ and \"a.\" =~ /a\\./", "true"},
        // What is not chosen is not looked at.
        Case{"true or unknown", "true"}, Case{"false and 1 / 0", "false"},
        Case{"true ? 1 : unknown", "1"}, Case{"false ? 1 / 0 : 2", "2"}));

class BadExpressionTest : public testing::TestWithParam<std::string> {};

TEST_P(BadExpressionTest, IsRefused) {
  const auto value = EvaluateExpression(GetParam(), Variables(), true);
  EXPECT_EQ(value.status().code(), absl::StatusCode::kInvalidArgument) << GetParam();
  EXPECT_TRUE(UnknownVariable(value.status()).empty());
}

INSTANTIATE_TEST_SUITE_P(Bad, BadExpressionTest,
                         testing::Values("", "1 +", "(1", "1 2", "\"open", "temperature[", "min(1",
                                         "1 ? 2", "\"a\" and true", "temperature[\"x\"]", "$x",
                                         "1 = 2", "1 =~ /1/", "\"a\" =~ \"a\"", "\"a\" =~ /a",
                                         "\"a\" =~ /(/", "9999999999999999999999e999",
                                         "temperature temperature", std::string(200, '('),
                                         std::string(5'000, '-') + "1",
                                         std::string(5'000, '!') + "1"));

TEST(EvaluateExpression, NamesWhatIsUnknown) {
  const auto value = EvaluateExpression("1 + no_such_thing[0]", Variables(), true);
  EXPECT_EQ(UnknownVariable(value.status()), "no_such_thing");
}

TEST(EvaluateExpression, WithoutEvaluationOnlyTheFormCounts) {
  EXPECT_TRUE(EvaluateExpression("unknown / 0 + f(\"a\")", Variables(), false).ok());
  EXPECT_FALSE(EvaluateExpression("unknown /", Variables(), false).ok());
}

}  // namespace
}  // namespace slicefarm::motion::template_expression_test
