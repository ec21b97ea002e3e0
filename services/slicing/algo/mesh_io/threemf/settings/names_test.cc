#include "services/slicing/algo/mesh_io/threemf/settings/names.h"

#include <gtest/gtest.h>

#include "common/base/utf8.h"

namespace slicefarm::slicing::threemf::names_test {
namespace {

TEST(CleanName, IsShortCleanText) {
  EXPECT_EQ(CleanName("  Gear 2 "), "Gear 2");
  EXPECT_EQ(CleanName("a\nb\x1b[0m"), "a b [0m");
  EXPECT_EQ(CleanName("\xff"), "?");
  std::string umlauts = "x";
  for (int i = 0; i < 200; ++i) umlauts += "ä";
  EXPECT_EQ(CleanName(umlauts).size(), 255u);
  EXPECT_TRUE(IsUtf8(CleanName(umlauts + umlauts)));
}

TEST(EscapedText, IsAsAConfigHasIt) {
  EXPECT_EQ(EscapedText("G28\r\nG1\tX"), "G28\\r\\nG1\tX");
  EXPECT_EQ(EscapedText("a\\nb\\\"c\\\"\\\\"), "a\\nb\\\"c\\\"\\\\");
  EXPECT_EQ(EscapedText("a\\\nb\\"), "a\\nb\\\\");
  EXPECT_EQ(EscapedText(std::string("a\0b\xff", 4)), "ab?");
}

}  // namespace
}  // namespace slicefarm::slicing::threemf::names_test
