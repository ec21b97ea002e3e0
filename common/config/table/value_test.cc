#include "common/config/table/value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace slicefarm::config::value_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ParseNumber, ReadsDecimals) {
  const std::pair<const char*, double> kCases[] = {
      {"0.2", 0.2},
      {" 15 ", 15},
      {"-0.05", -0.05},
      {"+3", 3},
      {"1e3", 1000},
      {".5", 0.5},
      {"5.", 5},
      {"0.1234567", 0.123457},
      {"-0.0", 0.0},
      {"1e-9", 0.0},
      {"999999999", 999999999},
  };
  for (const auto& [text, want] : kCases) {
    const auto value = ParseNumber(text, false);
    ASSERT_TRUE(value.ok()) << text;
    EXPECT_EQ(value->number, want) << text;
    EXPECT_FALSE(value->percent) << text;
    EXPECT_FALSE(std::signbit(value->number) && value->number == 0) << text;
  }
}

TEST(ParseNumber, ReadsPercentagesOnlyWhereTheyMayStand) {
  const auto value = ParseNumber("105 %", true);
  ASSERT_TRUE(value.ok());
  EXPECT_EQ(value->number, 105);
  EXPECT_TRUE(value->percent);
  EXPECT_FALSE(ParseNumber("105%", false).ok());
}

TEST(ParseNumber, RefusesWhatIsNoNumber) {
  for (const char* text : {"", " ", "%", "0.2mm", "0x10", "nan", "inf", "-inf", "1e10", "1e400",
                           "1,5", "1 2", "--1", "+-1", "one", "5%%"}) {
    EXPECT_FALSE(ParseNumber(text, true).ok()) << text;
  }
}

TEST(PrintNumber, IsShortAndReadsBackToTheSameBits) {
  EXPECT_EQ(PrintNumber(0.2), "0.2");
  EXPECT_EQ(PrintNumber(1000), "1000");
  EXPECT_EQ(PrintNumber(-0.05), "-0.05");
  EXPECT_EQ(PrintNumber(0.1 + 0.2), "0.3");
  EXPECT_EQ(PrintNumber(-1e-9), "0");
  EXPECT_EQ(PrintNumber(1e-6), "0.000001");
  EXPECT_EQ(PrintNumber(123456789.123456), "123456789.123456");
  for (int i = -2000; i < 2000; ++i) {
    const double number = Quantise(i * 0.0371234567);
    EXPECT_EQ(ParseNumber(PrintNumber(number), false)->number, number);
  }
}

TEST(Escape, ComesBack) {
  for (const std::string text : {"", "G28", "G28\nM84\n", "a\\nb", "\\", "\r\n", "tab\there"}) {
    EXPECT_EQ(Unescape(Escape(text)), text);
    EXPECT_EQ(Escape(text).find('\n'), std::string::npos);
  }
  EXPECT_EQ(Escape("G28\nM84"), "G28\\nM84");
  EXPECT_EQ(Unescape("end\\"), "end\\");
}

TEST(TextOfList, TakesTheFirstOfAList) {
  const std::pair<const char*, const char*> kCases[] = {
      {"PLA", "PLA"},
      {"PLA;PETG", "PLA"},
      {"", ""},
      {"\"\"", ""},
      {"\"a; b\";c", "a; b"},
      {"\"say \\\"hi\\\"\"", "say \"hi\""},
      {";PETG", ""},
      {"\"never closed", "never closed"},
      {"\"a\\nb\"", "a\nb"},
  };
  for (const auto& [list, want] : kCases) EXPECT_EQ(TextOfList(list), want) << list;
}

TEST(TextOfList, TakesTheItemOrTheFirst) {
  constexpr std::string_view kList = "\"a; b\"; c ;\"d\\\";e\"";
  EXPECT_EQ(TextOfList(kList, 0), "a; b");
  EXPECT_EQ(TextOfList(kList, 1), "c");
  EXPECT_EQ(TextOfList(kList, 2), "d\";e");
  EXPECT_EQ(TextOfList(kList, 3), "a; b");
}

TEST(QuoteText, ComesBack) {
  for (const std::string text :
       {"", "PLA", "Generic PLA", "a;b", "say \"hi\"", "back\\slash", "two\nlines", "#29B2B2"}) {
    EXPECT_EQ(TextOfList(QuoteText(text)), text);
  }
  EXPECT_EQ(QuoteText("PLA"), "PLA");
  EXPECT_EQ(QuoteText("Generic PLA"), "\"Generic PLA\"");
}

TEST(ParseBedShape, ReadsCorners) {
  const auto bed = ParseBedShape("0x0, 250x0,250x210,0x210");
  ASSERT_TRUE(bed.ok()) << bed.status();
  EXPECT_THAT(*bed, ElementsAre(Point{0, 0}, Point{250'000'000, 0}, Point{250'000'000, 210'000'000},
                                Point{0, 210'000'000}));
  EXPECT_EQ(PrintBedShape(*bed), "0x0,250x0,250x210,0x210");
}

TEST(ParseBedShape, TurnsClockwiseRingsRound) {
  const auto bed = ParseBedShape("0x0,0x10,10x10,10x0");
  ASSERT_TRUE(bed.ok());
  EXPECT_EQ(PrintBedShape(*bed), "10x0,10x10,0x10,0x0");
}

TEST(ParseBedShape, TakesConcaveAndOffCentreBeds) {
  EXPECT_TRUE(ParseBedShape("-50x-50,50x-50,50x50,0x0,-50x50").ok());
  EXPECT_TRUE(ParseBedShape("-86.6x-50,86.6x-50,0x100").ok());
}

TEST(ParseBedShape, DropsRepeatedCorners) {
  for (const char* text : {"0x0,256x0,256x256,0x256,0x256", "0x0,256x0,256x256,0x256,0x0",
                           "0x0,0x0,256x0,256x0,256x256,256x256,0x256,0x0,0x0"}) {
    const auto bed = ParseBedShape(text);
    ASSERT_TRUE(bed.ok()) << text << bed.status();
    EXPECT_EQ(PrintBedShape(*bed), "0x0,256x0,256x256,0x256") << text;
  }
}

TEST(ParseBedShape, SaysWhatIsWrong) {
  const std::pair<const char*, const char*> kCases[] = {
      {"", "XxY"},
      {"0x0,10x0", "fewer than three"},
      {"0x0,10x0,10", "XxY"},
      {"0x0,10x0,axb", "mm"},
      {"0x0,10x10,10x0,0x10", "crosses"},
      {"0x0,10x0,10x10,10x0", "crosses"},
      {"0x0,10x0,10x0,0x0", "fewer than three"},
      {"0x0,10x0,10x10,5x5,0x0,5x5,0x10", "crosses"},
      {"0x0,10x0,5x0", "crosses"},
      {"0x0,5000x0,0x10", "from the origin"},
  };
  for (const auto& [text, want] : kCases) {
    const auto bed = ParseBedShape(text);
    ASSERT_FALSE(bed.ok()) << text;
    EXPECT_THAT(std::string(bed.status().message()), HasSubstr(want)) << text;
  }
}

TEST(ParseBedShape, BoundsTheCorners) {
  std::string text = "0x0";
  for (int i = 1; i <= 1000; ++i) text += ",1x" + std::to_string(i);
  EXPECT_FALSE(ParseBedShape(text).ok());
}

TEST(ParseSizes, ReadsOldAndNewForms) {
  using Size = ThumbnailSize;
  EXPECT_THAT(*ParseSizes("16x16,220x124"), ElementsAre(Size{16, 16}, Size{220, 124}));
  EXPECT_THAT(*ParseSizes("16x16/PNG, 300x300/QOI"),
              ElementsAre(Size{16, 16}, Size{300, 300, PictureFormat::kQoi}));
  EXPECT_TRUE(ParseSizes("")->empty());
  EXPECT_EQ(PrintSizes({{16, 16}, {220, 124, PictureFormat::kQoi}}), "16x16,220x124/QOI");
}

TEST(ParseSizes, TakesAllFormats) {
  const char* text = "16x16/QOI, 313x173/BTT_TFT, 640x480/JPG, 1x1, 2x2/COLPIC";
  EXPECT_EQ(PrintSizes(*ParseSizes(text)), "16x16/QOI,313x173/BTT_TFT,640x480/JPG,1x1,2x2/COLPIC");
}

TEST(ParseSizes, RefusesWhatCannotBeMade) {
  for (const char* text : {"16", "16x", "x16", "0x16", "16x1025", "16x16/GIF", "16x16/PNG/x",
                           "-1x5", "1.5x2", "16x16,", "1x1,1x1,1x1,1x1,1x1,1x1,1x1,1x1,1x1"}) {
    EXPECT_FALSE(ParseSizes(text).ok()) << text;
  }
}

TEST(ParseAreas, ReadsRectanglesByFoursAndElseOnePolygon) {
  struct Case {
    const char* text;
    size_t areas;
    const char* printed;
  };
  for (const Case& each : {Case{"", 0, ""}, Case{"0x0", 0, ""}, Case{"0x0,0x0,0x0,0x0", 0, ""},
                           Case{"0x0, 18x0, 18x28, 0x28", 1, "0x0,18x0,18x28,0x28"},
                           Case{"0x28,18x28,18x0,0x0", 1, "0x0,18x0,18x28,0x28"},
                           Case{"25x245,25x240,115x240,115x245,208x245,208x240,245x240,245x245", 2,
                                "25x245,25x240,115x240,115x245,208x245,208x240,245x240,245x245"},
                           Case{"0x0,9x0,9x9,0x9,0x0,2x2,2x7,7x7,7x2,2x2", 1,
                                "0x0,9x0,9x9,0x9,0x0,2x2,2x7,7x7,7x2,2x2"},
                           Case{"0x0,5x0,3x4", 1, "0x0,5x0,3x4"}}) {
    const auto areas = ParseAreas(each.text);
    ASSERT_TRUE(areas.ok()) << each.text << ": " << areas.status();
    EXPECT_EQ(areas->size(), each.areas) << each.text;
    EXPECT_EQ(PrintAreas(*areas), each.printed);
    EXPECT_EQ(*ParseAreas(PrintAreas(*areas)), *areas) << each.text;
  }
  EXPECT_FALSE(ParseAreas("0x0,18").ok());
  EXPECT_FALSE(ParseAreas("a").ok());
}

TEST(ParsePoint, ReadsTwoNumbers) {
  EXPECT_EQ(*ParsePoint(" -1.5x2 "), (Point{-1'500'000, 2'000'000}));
  EXPECT_EQ(PrintPoint({-1'500'000, 2'000'000}), "-1.5x2");
  for (const char* bad : {"", "1", "1x", "1x2x3", "1,2", "9999999x0"})
    EXPECT_FALSE(ParsePoint(bad).ok()) << bad;
}

}  // namespace
}  // namespace slicefarm::config::value_test
