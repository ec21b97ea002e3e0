#include "services/motion/algo/macro/template_value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::motion::template_value_test {
namespace {

using ::testing::ElementsAre;

TEST(ToText, OfEachKind) {
  EXPECT_EQ(ToText(true), "true");
  EXPECT_EQ(ToText(int64_t{-5}), "-5");
  EXPECT_EQ(ToText(0.2), "0.2");
  EXPECT_EQ(ToText(3.0), "3");
  EXPECT_EQ(ToText(-0.0), "0");
  EXPECT_EQ(ToText(1.0 / 3), "0.333333");
  EXPECT_EQ(ToText(std::string("PLA")), "PLA");
}

TEST(FindValue, PastTheEndIsTheFirst) {
  const TemplateVariables variables = {{"list", {int64_t{7}, int64_t{8}}}, {"none", {}}};
  EXPECT_EQ(*FindValue(variables, "list", 1), TemplateValue(int64_t{8}));
  EXPECT_EQ(*FindValue(variables, "list", 2), TemplateValue(int64_t{7}));
  EXPECT_EQ(*FindValue(variables, "list", -1), TemplateValue(int64_t{7}));
  EXPECT_EQ(FindValue(variables, "none", 0), nullptr);
  EXPECT_EQ(FindValue(variables, "other", 0), nullptr);
}

TEST(ParseSetting, TellsNumbersFromText) {
  EXPECT_THAT(ParseSetting("210"), ElementsAre(TemplateValue(int64_t{210})));
  EXPECT_THAT(ParseSetting("0.45"), ElementsAre(TemplateValue(0.45)));
  EXPECT_THAT(ParseSetting("210,0.5"),
              ElementsAre(TemplateValue(int64_t{210}), TemplateValue(0.5)));
  EXPECT_THAT(ParseSetting("20%"), ElementsAre(TemplateValue(std::string("20%"))));
  EXPECT_THAT(ParseSetting("0x0,250x0"), ElementsAre(TemplateValue(std::string("0x0,250x0"))));
  EXPECT_THAT(ParseSetting(""), ElementsAre(TemplateValue(std::string())));
  EXPECT_THAT(ParseSetting("1,"), ElementsAre(TemplateValue(std::string("1,"))));
}

}  // namespace
}  // namespace slicefarm::motion::template_value_test
