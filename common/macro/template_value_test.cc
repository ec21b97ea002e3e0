#include "common/macro/template_value.h"

#include <gtest/gtest.h>

namespace slicefarm::macro::template_value_test {
namespace {

TEST(ToText, OfEachKind) {
  EXPECT_EQ(ToText(true), "true");
  EXPECT_EQ(ToText(int64_t{-5}), "-5");
  EXPECT_EQ(ToText(0.2), "0.2");
  EXPECT_EQ(ToText(3.0), "3");
  EXPECT_EQ(ToText(-0.0), "0");
  EXPECT_EQ(ToText(1.0 / 3), "0.333333");
  EXPECT_EQ(ToText(1234.5678), "1234.57");
  EXPECT_EQ(ToText(0.00001), "1e-05");
  EXPECT_EQ(ToText(std::string("PLA")), "PLA");
  EXPECT_EQ(ToText(Unknown{}), "");
}

TEST(ItemOf, PastTheEndIsTheFirst) {
  const auto list = TemplateVariable::List({int64_t{7}, int64_t{8}});
  EXPECT_EQ(*ItemOf(list, 1), TemplateValue(int64_t{8}));
  EXPECT_EQ(*ItemOf(list, 2), TemplateValue(int64_t{7}));
  EXPECT_EQ(*ItemOf(list, -1), TemplateValue(int64_t{7}));
  EXPECT_EQ(ItemOf(TemplateVariable(), 0), nullptr);
}

}  // namespace
}  // namespace slicefarm::macro::template_value_test
