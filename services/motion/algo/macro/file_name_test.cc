#include "services/motion/algo/macro/file_name.h"

#include <gtest/gtest.h>

#include <string>

#include "common/model/options/motion_options.h"

namespace slicefarm::motion::file_name_test {
namespace {

TEST(ShortTime, IsPrusaSlicers) {
  struct Case {
    double seconds;
    const char* want;
  };
  for (const Case& c : {Case{0, "0s"}, Case{59.9, "59s"}, Case{60, "1m"}, Case{89, "1m"},
                        Case{90, "2m"}, Case{3600, "1h0m"}, Case{3 * 3600 + 59 * 60 + 31, "4h0m"},
                        Case{86'399, "1d0h0m"}, Case{90'000, "1d1h0m"}})
    EXPECT_EQ(ShortTime(c.seconds), c.want) << c.seconds;
}

WritingOptions Text() { return {}; }
WritingOptions Binary() {
  WritingOptions writing;
  writing.binary = true;
  return writing;
}
WritingOptions Archive() {
  WritingOptions writing = Binary();
  writing.archive = true;
  return writing;
}
TEST(FileName, NamesNoFolderAndEndsAsTheFileIs) {
  struct Case {
    const char* given;
    WritingOptions writing;
    const char* want;
  };
  const Case cases[] = {
      {"part.gcode", Text(), "part.gcode"},
      {"part.gcode", Binary(), "part.bgcode"},
      {"part.BGCODE", Text(), "part.gcode"},
      {"part_0.2mm_PLA_1h2m", Text(), "part_0.2mm_PLA_1h2m"},
      {"part", Binary(), "part.bgcode"},
      {"part.gco", Binary(), "part.gco"},
      {"../../etc/passwd.gcode", Text(), ".._.._etc_passwd.gcode"},
      {"a\\b:c*d?e\"f<g>h|i\nj", Text(), "a_b_c_d_e_f_g_h_i_j.gcode"},
      {"", Text(), "print.gcode"},
      {".gcode", Binary(), "print.bgcode"},
      {"..", Text(), "print.gcode"},
      {"part.gcode", Archive(), "part.gcode.3mf"},
      {"part.Gcode.3MF", Archive(), "part.gcode.3mf"},
      {"part.gcode.3mf", Text(), "part.gcode"},
      {"part", Archive(), "part.gcode.3mf"},
      {" ä ", Text(), "ä.gcode"},
  };
  for (const Case& c : cases) EXPECT_EQ(FileName(c.given, c.writing), c.want) << c.given;
}

TEST(FileName, IsShortEnoughForAnyFileSystem) {
  std::string umlauts;
  for (int i = 0; i < 200; ++i) umlauts += "ä";
  const std::string name = FileName(umlauts + ".gcode", Text());
  EXPECT_LE(name.size(), 240u);
  EXPECT_TRUE(name.ends_with("ä.gcode"));
  EXPECT_LE(FileName("a." + std::string(1000, 'b'), Text()).size(), 240u);
}

}  // namespace
}  // namespace slicefarm::motion::file_name_test
