#include "services/motion/algo/macro/template_arithmetic.h"

#include <gtest/gtest.h>

#include <limits>

namespace slicefarm::motion::template_arithmetic_test {
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

TEST(Call, Functions) {
  EXPECT_EQ(*Call("min", {int64_t{2}, 1.5}), TemplateValue(1.5));
  EXPECT_EQ(*Call("max", {int64_t{2}, 1.5}), TemplateValue(int64_t{2}));
  EXPECT_EQ(*Call("int", {-1.7}), TemplateValue(int64_t{-1}));
  EXPECT_EQ(*Call("round", {-1.7}), TemplateValue(int64_t{-2}));
  EXPECT_EQ(*Call("digits", {int64_t{5}, int64_t{3}}), TemplateValue(std::string("  5")));
  EXPECT_EQ(*Call("zdigits", {1.26, int64_t{6}, int64_t{1}}), TemplateValue(std::string("0001.3")));
}

TEST(Call, Refuses) {
  EXPECT_FALSE(Call("system", {int64_t{1}}).ok());
  EXPECT_FALSE(Call("min", {int64_t{1}}).ok());
  EXPECT_FALSE(Call("int", {1e300}).ok());
  EXPECT_FALSE(Call("int", {std::string("x")}).ok());
  EXPECT_FALSE(Call("digits", {int64_t{5}, int64_t{1'000'000'000}}).ok());
  EXPECT_FALSE(Call("digits", {1e300, int64_t{5}}).ok());
}

}  // namespace
}  // namespace slicefarm::motion::template_arithmetic_test
