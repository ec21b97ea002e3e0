#include "common/gcode/binary/meatpack.h"

#include <gtest/gtest.h>

#include <string>

namespace slicefarm::gcode::meatpack_test {
namespace {

const std::string kBegin = "\xff\xff\xfb\xff\xff\xf7";
const std::string kOff = "\xff\xff\xfa";
const std::string kOn = "\xff\xff\xfb";

std::string Bytes(std::initializer_list<int> bytes) {
  std::string text;
  for (const int byte : bytes) text += static_cast<char>(byte);
  return text;
}

TEST(MeatPack, PacksPairsAsTheFormatSays) {
  struct Case {
    const char* name;
    const char* lines;
    std::string want;
  };
  const Case cases[] = {
      {"nothing", "", ""},
      // G1, X1, .5, end of line twice.
      {"a move", "G1 X1.5\n", Bytes({0x1d, 0x1e, 0x5a, 0xcc})},
      {"E is packed in place of blanks", "G1 E2\n", Bytes({0x1d, 0x2b, 0xcc})},
      {"first whole", "M1\n", Bytes({0x1f, 'M', 0xcc})},
      {"second whole", "1M\n", Bytes({0xf1, 'M', 0xcc})},
      {"both whole", "FY\n", Bytes({0xff, 'F', 'Y', 0xcc})},
      {"blanks stay where words need them", "M117 a\n",
       Bytes({0x1f, 'M', 0x71, 0xff, ' ', 'a', 0xcc})},
      {"a comment after a command", "G1 ; up\n", Bytes({0x1d, 0xcc})},
      {"blanks around", "  G1 \r\n", Bytes({0x1d, 0xcc})},
      {"no end", "G1", Bytes({0x1d, 0xcc})},
      {"empty lines", "\n \n ; x\n", ""},
      {"an odd number", "G28\n", Bytes({0x2d, 0xc8})},
      {"no byte looks like a signal", "\xff\xff\n", Bytes({0xff, '?', '?', 0xcc})},
  };
  for (const Case& c : cases) EXPECT_EQ(MeatPack(c.lines), kBegin + c.want) << c.name;
}

TEST(MeatPack, LeavesCommentLinesAsTheyAre) {
  EXPECT_EQ(MeatPack(";TYPE:Skirt\n; b\nG1\nG1\n;end"), kBegin + kOff + ";TYPE:Skirt\n; b\n" + kOn +
                                                            Bytes({0x1d, 0xcc, 0x1d, 0xcc}) + kOff +
                                                            ";end\n");
}

}  // namespace
}  // namespace slicefarm::gcode::meatpack_test
