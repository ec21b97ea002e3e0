#include "common/gcode/gcode_text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <random>

namespace slicefarm::gcode_text_test {
namespace {

std::string Um(int64_t um) { return GcodeText().Micrometers(um).text(); }
std::string E(int64_t units) { return GcodeText().Filament(units).text(); }

TEST(GcodeText, Micrometers) {
  EXPECT_EQ(Um(0), "0");
  EXPECT_EQ(Um(5), ".005");
  EXPECT_EQ(Um(-50), "-.05");
  EXPECT_EQ(Um(1'000), "1");
  EXPECT_EQ(Um(123'450), "123.45");
  EXPECT_EQ(Um(-1'200), "-1.2");
  EXPECT_EQ(Um(2'147'483'647), "2147483.647");
}

TEST(GcodeText, Filament) {
  EXPECT_EQ(E(1), ".00001");
  EXPECT_EQ(E(-80'000), "-.8");
  EXPECT_EQ(E(123'456), "1.23456");
}

TEST(GcodeText, Real) {
  EXPECT_EQ(GcodeText().Real(0.2, 3).text(), "0.2");
  EXPECT_EQ(GcodeText().Real(-0.0004, 3).text(), "0");
  EXPECT_EQ(GcodeText().Real(-0.05, 3).text(), "-0.05");
  EXPECT_EQ(GcodeText().Real(12.3456, 2).text(), "12.35");
}

TEST(GcodeText, RealOfAnySizeEnds) {
  EXPECT_EQ(GcodeText().Real(-1e300, 3).text(), "-9000000000000");
  EXPECT_EQ(GcodeText().Real(std::numeric_limits<double>::infinity(), 5).text(), "9000000000000");
  EXPECT_EQ(GcodeText().Real(std::numeric_limits<double>::quiet_NaN(), 3).text(), "0");
}

TEST(GcodeText, ReadsBackAsTheSameNumber) {
  std::mt19937 random(1);
  for (int i = 0; i < 10'000; ++i) {
    const auto um = static_cast<int64_t>(random() % 4'000'000) - 2'000'000;
    ASSERT_EQ(std::llround(std::strtod(Um(um).c_str(), nullptr) * 1e3), um);
    ASSERT_EQ(std::llround(std::strtod(E(um).c_str(), nullptr) * 1e5), um);
  }
}

TEST(GcodeText, DecimalsOfOtherUnits) {
  EXPECT_EQ(GcodeText().Decimal(-5, 4).text(), "-0.0005");
  EXPECT_EQ(GcodeText().Mm(1'234'567, 4).text(), "1.2346");
  EXPECT_EQ(GcodeText().Fixed(1, 3).text(), "1.000");
  EXPECT_EQ(GcodeText().Fixed(-0.0625, 3).text(), "-0.062") << "exactly between: to the even one";
  EXPECT_EQ(GcodeText().Fixed(std::numeric_limits<double>::max(), 3).text().size(), 313u);
}

TEST(GcodeText, LinesAreEnded) {
  GcodeText text;
  text.Lines("");
  EXPECT_EQ(text.text(), "");
  text.Lines("G28");
  EXPECT_EQ(text.text(), "G28\n");
  text.Lines("").Lines("G29\nG30\n");
  EXPECT_EQ(text.Integer(-7).Take(), "G28\nG29\nG30\n-7");
}

}  // namespace
}  // namespace slicefarm::gcode_text_test
