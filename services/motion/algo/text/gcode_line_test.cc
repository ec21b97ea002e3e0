#include "services/motion/algo/text/gcode_line.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace slicefarm::motion::gcode_line_test {
namespace {

TEST(ParseGcodeLine, CommandAndWords) {
  const GcodeLine line = ParseGcodeLine("G1 X10 Y-.5 E+.03 F1200 ; to the wall");
  EXPECT_EQ(line.command, "G1");
  EXPECT_TRUE(line.Is('G', 1));
  EXPECT_EQ(line['X'], 10);
  EXPECT_EQ(line['Y'], -0.5);
  EXPECT_EQ(line['E'], 0.03);
  EXPECT_EQ(line['Z'], std::nullopt);
  EXPECT_EQ(line.comment, " to the wall");
  EXPECT_EQ(line.fault, "");
}

TEST(ParseGcodeLine, InOneWordInSmallLettersWithNumberAndChecksum) {
  const GcodeLine line = ParseGcodeLine("N12 g1x1.5y2*71");
  EXPECT_TRUE(line.Is('G', 1));
  EXPECT_EQ(line['X'], 1.5);
  EXPECT_EQ(line['Y'], 2);
  EXPECT_EQ(line.fault, "");
}

TEST(ParseGcodeLine, BareWordsAreThereWithoutNumber) {
  const GcodeLine line = ParseGcodeLine("G28 X Y");
  EXPECT_TRUE(line.Has('X'));
  EXPECT_FALSE(line.Has('Z'));
  EXPECT_EQ(line['X'], std::nullopt);
}

TEST(ParseGcodeLine, NamedCommands) {
  const GcodeLine line = ParseGcodeLine("SET_VELOCITY_LIMIT accel=3000 VELOCITY=12.5");
  EXPECT_EQ(line.command, "SET_VELOCITY_LIMIT");
  EXPECT_EQ(line.letter, 0);
  EXPECT_EQ(line.NamedNumber("ACCEL"), 3000);
  EXPECT_EQ(line.NamedNumber("VELOCITY"), 12.5);
  EXPECT_EQ(line.NamedNumber("CEL"), std::nullopt);
}

TEST(ParseGcodeLine, TextIsNoWords) {
  EXPECT_EQ(ParseGcodeLine("M117 50% done!").fault, "");
  EXPECT_EQ(ParseGcodeLine("M862.3 P \"MK3S\"").number, 862);
  EXPECT_EQ(ParseGcodeLine("M486 Aa cube (2)").fault, "");
  EXPECT_EQ(ParseGcodeLine("M624 AQAAAAAAAAA=").fault, "");
  EXPECT_EQ(ParseGcodeLine("Tx").letter, 'T');
  EXPECT_EQ(ParseGcodeLine("").command, "");
  EXPECT_EQ(ParseGcodeLine("  \t").command, "");
}

TEST(ParseGcodeLine, ListsAndTextsInQuotes) {
  const GcodeLine list = ParseGcodeLine("M567 P0 E0.8:.2");
  EXPECT_EQ(list.fault, "");
  EXPECT_EQ(list['E'], 0.8);
  EXPECT_TRUE(list.has_lists);
  const GcodeLine text = ParseGcodeLine("M950 H0 C\"out0 + out1\" T1");
  EXPECT_EQ(text.fault, "");
  EXPECT_EQ(text['C'], std::nullopt);
  EXPECT_EQ(text['T'], 1);
  EXPECT_TRUE(text.has_lists);
  EXPECT_FALSE(ParseGcodeLine("M92 E420").has_lists);
}

TEST(ParseGcodeLine, Faults) {
  for (const char* text :
       {"G1 X1 X2", "G1 X1.2.3", "G1 X-", "G1 Xnan", "G1 10", "G1 X1 %", "G1 X99999999999",
        "M567 E1:", "M567 E:1", "M567 E1:x", "M950 C\"out0"}) {
    EXPECT_NE(ParseGcodeLine(text).fault, "") << text;
  }
}

TEST(ParseGcodeLine, TakesAnyBytes) {
  std::mt19937 random(1);
  for (int i = 0; i < 20'000; ++i) {
    std::string text(random() % 20, ' ');
    for (char& c : text)
      c = static_cast<char>(random() % 3 == 0 ? random() : "GMX 1.-;="[random() % 9]);
    const GcodeLine line = ParseGcodeLine(text);
    EXPECT_LE(line.command.size(), text.size());
  }
}

}  // namespace
}  // namespace slicefarm::motion::gcode_line_test
