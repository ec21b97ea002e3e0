#include "common/base/split_mix.h"

#include <gtest/gtest.h>

namespace slicefarm::split_mix_test {
namespace {

// The expected values are the first numbers of the reference implementation for the seed 0.
TEST(SplitMix, GivesTheNumbersOfTheReference) {
  SplitMix random(0);
  EXPECT_EQ(random.Bits(), 0xe220a8397b1dcdafu);
  EXPECT_EQ(random.Bits(), 0x6e789e6aa1b965f4u);
  EXPECT_EQ(MixedBits(kSplitMixStep), 0xe220a8397b1dcdafu);
}

TEST(SplitMix, SharesAreFromZeroToBelowOne) {
  EXPECT_EQ(ShareOfBits(0), 0);
  EXPECT_EQ(ShareOfBits(uint64_t{1} << 63), 0.5);
  EXPECT_LT(ShareOfBits(~uint64_t{0}), 1);
}

}  // namespace
}  // namespace slicefarm::split_mix_test
