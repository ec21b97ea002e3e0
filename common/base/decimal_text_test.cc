#include "common/base/decimal_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace slicefarm::decimal_text_test {
namespace {

std::string Decimal(int64_t value, int digits) {
  std::string text;
  AppendDecimal(text, value, digits);
  return text;
}

std::string Mm(int64_t nm, int digits) {
  std::string text;
  AppendMm(text, nm, digits);
  return text;
}

TEST(DecimalText, HasNoZerosAtItsEnd) {
  EXPECT_EQ(Decimal(0, 3), "0");
  EXPECT_EQ(Decimal(1'500, 3), "1.5");
  EXPECT_EQ(Decimal(-5, 3), "-0.005");
  EXPECT_EQ(Decimal(12'000, 3), "12");
  EXPECT_EQ(Decimal(7, 0), "7");
  EXPECT_EQ(Decimal(1'000'001, 6), "1.000001");
  EXPECT_EQ(Decimal(std::numeric_limits<int64_t>::max(), 6), "9223372036854.775807");
  EXPECT_EQ(Decimal(-std::numeric_limits<int64_t>::max(), 0), "-9223372036854775807");
}

TEST(DecimalText, MayLeaveOutTheZeroBeforeThePoint) {
  char buffer[kLongestDecimal];
  const auto text = [&](int64_t value) {
    return std::string(buffer, WriteDecimal(buffer, value, 3, false));
  };
  EXPECT_EQ(text(50), ".05");
  EXPECT_EQ(text(-50), "-.05");
  EXPECT_EQ(text(0), "0");
  EXPECT_EQ(text(1'050), "1.05");
}

TEST(DecimalText, RoundsNanometresHalfAwayFromZero) {
  EXPECT_EQ(Mm(1'234'567, 6), "1.234567");
  EXPECT_EQ(Mm(1'234'567, 4), "1.2346");
  EXPECT_EQ(Mm(50, 4), "0.0001");
  EXPECT_EQ(Mm(-50, 4), "-0.0001");
  EXPECT_EQ(Mm(49, 4), "0");
  EXPECT_EQ(Mm(-2'500'000, 0), "-3");
}

}  // namespace
}  // namespace slicefarm::decimal_text_test
