#include "services/motion/algo/text/comment_text.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::comment_text_test {
namespace {

TEST(OneLine, NothingEndsTheLine) {
  EXPECT_EQ(OneLine("a\nM112\r\nb"), "a\\nM112\\r\\nb");
  EXPECT_EQ(OneLine("C:\\x"), "C:\\\\x");
  EXPECT_EQ(OneLine(std::string("tab\tbell\a nul") + '\0' + "\x7f\v\f"), "tab bell  nul    ");
  EXPECT_EQ(OneLine("a\u0085b\u2028c"), "a b c");
  EXPECT_EQ(OneLine("Schlüssel"), "Schlüssel");
}

TEST(CommentLine, LeavesEscapesAlone) {
  EXPECT_EQ(CommentLine("a\\nb"), "a\\nb");
  EXPECT_EQ(CommentLine("a\nG28\rb"), "a G28 b");
  EXPECT_EQ(CommentLine("a\u2028G28"), "a G28");
}

TEST(JsonString, QuotesAndEscapes) {
  EXPECT_EQ(JsonString("a\"b\\c\nd"), "\"a\\\"b\\\\c d\"");
  EXPECT_EQ(JsonString("a\u2029b"), "\"a b\"");
  EXPECT_EQ(JsonString(""), "\"\"");
}

}  // namespace
}  // namespace slicefarm::motion::comment_text_test
