#include "services/motion/algo/gcode/thumbnails_block.h"

#include <gtest/gtest.h>

#include <regex>

#include "absl/strings/escaping.h"

namespace slicefarm::motion::thumbnails_block_test {
namespace {

TEST(ThumbnailsBlock, NothingToShow) {
  EXPECT_EQ(ThumbnailsBlock({}), "");
  EXPECT_EQ(ThumbnailsBlock({{32, 32, ""}}), "");
}

TEST(ThumbnailsBlock, SmallPicture) {
  EXPECT_EQ(ThumbnailsBlock({{2, 3, "PNG!"}}),
            "; thumbnail begin 2x3 8\n; UE5HIQ==\n; thumbnail end\n;\n");
}

// Reads the block as Moonraker does: the count of characters, without the line breaks, must be the
// length of the code.
TEST(ThumbnailsBlock, PrinterHostsCanReadIt) {
  std::string png;
  for (int i = 0; i < 5'000; ++i) png += static_cast<char>(i * 7);
  const std::string block = ThumbnailsBlock({{300, 300, png}});
  std::smatch match;
  const std::regex head("; thumbnail begin (\\d+)[x ](\\d+) (\\d+)\n");
  ASSERT_TRUE(std::regex_search(block, match, head));
  EXPECT_EQ(match[1], "300");
  std::string code;
  size_t longest = 0;
  const size_t end = block.find("; thumbnail end");
  for (size_t at = static_cast<size_t>(match.length(0)); at < end;) {
    const size_t stop = block.find('\n', at);
    EXPECT_EQ(block.substr(at, 2), "; ");
    code += block.substr(at + 2, stop - at - 2);
    longest = std::max(longest, stop - at - 2);
    at = stop + 1;
  }
  EXPECT_EQ(std::to_string(code.size()), match[3]);
  EXPECT_EQ(longest, 78);
  std::string decoded;
  ASSERT_TRUE(absl::Base64Unescape(code, &decoded));
  EXPECT_EQ(decoded, png);
}

TEST(ThumbnailsBlock, TextForScreens) {
  const Thumbnail first{2, 3, "abc", PictureFormat::kColPic};
  const Thumbnail second{2, 3, "def", PictureFormat::kColPic};
  const Thumbnail rows{1, 1, ";00010001\r\n;ffff\r\n", PictureFormat::kBtt};
  EXPECT_EQ(ThumbnailsBlock({first, second, rows}),
            "\n;gimage:abc\n\n\n;simage:def\n\n;00010001\r\n;ffff\r\n"
            "; bigtree thumbnail end\r\n\r\n");
}

}  // namespace
}  // namespace slicefarm::motion::thumbnails_block_test
