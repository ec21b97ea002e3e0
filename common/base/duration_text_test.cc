#include "common/base/duration_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace slicefarm::duration_text_test {
namespace {

TEST(DurationText, LeadingUnitsOfZeroAreLeftOut) {
  EXPECT_EQ(DurationText(0), "0s");
  EXPECT_EQ(DurationText(59.6), "1m 0s");
  EXPECT_EQ(DurationText(59.4), "59s");
  EXPECT_EQ(DurationText(3'600), "1h 0m 0s");
  EXPECT_EQ(DurationText(86'400 + 2 * 3'600 + 3 * 60 + 4), "1d 2h 3m 4s");
}

TEST(DurationText, NonsenseIsBounded) {
  EXPECT_EQ(DurationText(-5), "0s");
  EXPECT_FALSE(DurationText(std::numeric_limits<double>::infinity()).empty());
}

}  // namespace
}  // namespace slicefarm::duration_text_test
