#include "common/base/shared/shared_text.h"

#include <gtest/gtest.h>

#include <string>

namespace slicefarm::shared_text_test {
namespace {

TEST(SharedText, IsItsText) {
  const SharedText none, a = "a", b = std::string("b"), c = std::string_view("c");
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none, SharedText(""));
  EXPECT_EQ(a.str(), "a");
  EXPECT_EQ(std::string_view(b), "b");
  EXPECT_EQ(c.size(), 1u);
  EXPECT_EQ(a, SharedText("a"));
  EXPECT_FALSE(a == b);
}

TEST(SharedText, CopiesAreTheSameText) {
  SharedText a = "a";
  const SharedText copy = a;
  EXPECT_EQ(&copy.str(), &a.str());
  EXPECT_EQ(&a.Once([](const std::string& text) { return text + "!"; }),
            &copy.Once([](const std::string& text) { return text + "!"; }));
  a.clear();
  EXPECT_TRUE(a.empty());
  EXPECT_EQ(copy.str(), "a");
}

}  // namespace
}  // namespace slicefarm::shared_text_test
