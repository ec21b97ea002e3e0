#include "common/macro/template_arithmetic.h"

#include <gtest/gtest.h>

#include <limits>

namespace slicefarm::macro::template_arithmetic_test {
namespace {

constexpr int64_t kMost = std::numeric_limits<int64_t>::max();
constexpr int64_t kLeast = std::numeric_limits<int64_t>::min();

TEST(Apply, WholeNumbersStayWhole) {
  EXPECT_EQ(*Apply("/", int64_t{7}, int64_t{2}), TemplateValue(int64_t{3}));
  EXPECT_EQ(*Apply("%", int64_t{7}, int64_t{2}), TemplateValue(int64_t{1}));
  EXPECT_EQ(*Apply("/", int64_t{7}, 2.0), TemplateValue(3.5));
}

TEST(Apply, OverflowAndZero) {
  EXPECT_FALSE(Apply("+", kMost, int64_t{1}).ok());
  EXPECT_FALSE(Apply("*", kMost, int64_t{2}).ok());
  EXPECT_FALSE(Apply("/", kLeast, int64_t{-1}).ok());
  EXPECT_FALSE(Apply("%", kLeast, int64_t{-1}).ok());
  EXPECT_FALSE(Apply("/", int64_t{1}, int64_t{0}).ok());
  EXPECT_FALSE(Apply("%", 1.0, 0.0).ok());
  EXPECT_FALSE(Negated(kLeast).ok());
}

TEST(Apply, Texts) {
  EXPECT_EQ(*Apply("+", std::string("a"), int64_t{1}), TemplateValue(std::string("a1")));
  EXPECT_EQ(*Apply("==", std::string("PLA"), std::string("PLA")), TemplateValue(true));
  EXPECT_FALSE(Apply("*", std::string("a"), int64_t{1}).ok());
  EXPECT_FALSE(Apply("+", true, int64_t{1}).ok());
}

TEST(Call, RefusesWhatDoesNotFit) {
  const auto call = [](std::string_view function, std::vector<TemplateValue> arguments) {
    return Call(function, arguments).ok();
  };
  EXPECT_FALSE(call("int", {1e300}));
  EXPECT_FALSE(call("int", {std::string("x")}));
  EXPECT_FALSE(call("min", {std::string("x"), int64_t{1}}));
  EXPECT_FALSE(call("digits", {1e300, int64_t{5}}));
  EXPECT_FALSE(call("interpolate_table", {std::string("x"), 0.0, 1.0}));
  EXPECT_TRUE(call("digits", {int64_t{5}, int64_t{1'000'000'000}}));
}

}  // namespace
}  // namespace slicefarm::macro::template_arithmetic_test
