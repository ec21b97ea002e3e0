#include "common/model/options/height_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace slicefarm::height_code_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(HeightCode, ComesBackByHeightAndInOneLine) {
  const auto codes = ParseHeightCodes(
      R"( [{"type":"custom","z":3,"text":"M117 a\nM0"}, {"z":1.2,"type":"pause","text":"ä"},)"
      R"({"z":1.2,"type":"color_change","text":"#00FF00"},{"z":2,"type":"template"}] )");
  ASSERT_TRUE(codes.ok()) << codes.status();
  EXPECT_THAT(*codes, ElementsAre(HeightCode{1'200'000, HeightCodeKind::kPause, "ä"},
                                  HeightCode{1'200'000, HeightCodeKind::kColorChange, "#00FF00"},
                                  HeightCode{2'000'000, HeightCodeKind::kTemplate, ""},
                                  HeightCode{3'000'000, HeightCodeKind::kCustom, "M117 a\nM0"}));
  const std::string text = PrintHeightCodes(*codes);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(*ParseHeightCodes(text), *codes);
  EXPECT_EQ(PrintHeightCodes(*ParseHeightCodes(text)), text);
}

TEST(HeightCode, ARetractionHasALength) {
  const auto codes = ParseHeightCodes(R"([{"z":1,"type":"retract_length","text":"0.45"}])");
  ASSERT_TRUE(codes.ok()) << codes.status();
  EXPECT_EQ(RetractLengthMm(codes->front()), 0.45);
  EXPECT_EQ(*ParseHeightCodes(PrintHeightCodes(*codes)), *codes);
  for (const char* text : {R"("text":"")", R"("text":"-1")", R"("text":"1mm")", R"("text":"inf")",
                           R"("text":"nan")", R"("text":"1e9")", R"("text":1)", R"("z":2)"}) {
    const std::string list = std::string(R"([{"z":1,"type":"retract_length",)") + text + "}]";
    EXPECT_FALSE(ParseHeightCodes(list).ok()) << text;
  }
}

TEST(HeightCode, NothingIsNoCode) {
  EXPECT_TRUE(ParseHeightCodes(" ")->empty());
  EXPECT_TRUE(ParseHeightCodes("[]")->empty());
  EXPECT_EQ(PrintHeightCodes({}), "");
}

TEST(HeightCode, WhatIsNoListOfCodesIsRefused) {
  struct Case {
    const char* text;
    const char* why;
  };
  const Case cases[] = {
      {"{}", "JSON list"},
      {"[1]", "must be an object"},
      {"[", "JSON list"},
      {R"([{"z":1}])", "type must be"},
      {R"([{"z":1,"type":"dance"}])", "type must be"},
      {R"([{"z":1,"type":7}])", "type must be"},
      {R"([{"type":"pause"}])", "z must be"},
      {R"([{"z":0,"type":"pause"}])", "z must be"},
      {R"([{"z":1e9,"type":"pause"}])", "z must be"},
      {R"([{"z":"1","type":"pause"}])", "z must be"},
      {R"([{"z":1,"type":"pause","text":3}])", "text must be"},
      {R"([{"z":1,"type":"custom","text":"\u0007"}])", "control"},
      {R"([{"z":1,"type":"pause","text":"a\nM112"}])", "one line"},
      {R"([{"z":1,"type":"color_change","text":"#1\n"}])", "one line"},
      {R"([{"z":1,"type":"pause","tool":2}])", "unknown entry 'tool'"},
  };
  for (const Case& c : cases)
    EXPECT_THAT(std::string(ParseHeightCodes(c.text).status().message()), HasSubstr(c.why))
        << c.text;
}

TEST(HeightCode, DeepNestingAndGreatNumbersAreRefused) {
  EXPECT_FALSE(ParseHeightCodes(std::string(100'000, '[')).ok());
  EXPECT_FALSE(ParseHeightCodes(std::string(1'000, '[') + std::string(1'000, ']')).ok());
  std::string many = "[";
  for (int i = 0; i <= kMaxHeightCodes; ++i) many += R"({"z":1,"type":"template"},)";
  many.back() = ']';
  EXPECT_FALSE(ParseHeightCodes(many).ok());
}

}  // namespace
}  // namespace slicefarm::height_code_test
