#include "common/model/options/fill_angles.h"

#include <gtest/gtest.h>

namespace slicefarm::fill_angles_test {
namespace {

struct Case {
  const char* text;
  double base;
  std::vector<double> want;  ///< expected angle of each layer
};

TEST(FillAngles, TurnLayerByLayer) {
  const Case cases[] = {
      {"45", 10, {45, 45, 45}},
      {"0,90", 10, {0, 90, 0, 90}},
      {"0,45,90", 0, {0, 45, 90, 0}},
      {"90#2,0", 0, {90, 90, 0, 90, 90, 0}},
      {"+30", 45, {75, 105, 135, 165}},
      {"-90", 45, {315, 225, 135, 45, 315}},
      {"+10,+20", 0, {10, 30, 40, 60, 70}},
      {"10,+20", 5, {10, 30, 10, 30}},
      {"+20,10", 5, {25, 10, 30, 10, 30}},
      {"+5#2, 100", 1, {6, 11, 100, 105, 110, 100}},
  };
  for (const Case& c : cases) {
    const auto steps = ParseFillAngles(c.text);
    ASSERT_TRUE(steps.ok()) << c.text;
    for (size_t layer = 0; layer < c.want.size(); ++layer)
      EXPECT_DOUBLE_EQ(FillAngleAt(*steps, c.base, static_cast<int32_t>(layer)), c.want[layer])
          << c.text << " " << layer;
  }
}

TEST(FillAngles, ArePrintedAsTheyAreRead) {
  EXPECT_EQ(PrintFillAngles(*ParseFillAngles(" 0, 45.5 ,+30,-15")), "0,45.5,+30,-15");
  EXPECT_EQ(PrintFillAngles(*ParseFillAngles("90,90,0#3")), "90#2,0#3");
  for (const char* text : {"0,90", "+30", "-1#7,+0,360"})
    EXPECT_EQ(PrintFillAngles(*ParseFillAngles(text)), text);
}

TEST(FillAngles, RefuseWhatIsNone) {
  for (const char* text : {"", ",", "x", "1,,2", "361", "+", "5#0", "5#1.5", "5#", "#2", "1#1001",
                           "nan", "1#600,2#600"})
    EXPECT_FALSE(ParseFillAngles(text).ok()) << text;
}

}  // namespace
}  // namespace slicefarm::fill_angles_test
