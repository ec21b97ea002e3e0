#include "services/infill/algo/linking/part_beside.h"

#include <gtest/gtest.h>

namespace slicefarm::infill::part_beside_test {
namespace {

constexpr Point kA{0, 0}, kB{10'000, 0};

TEST(PartBeside, OfParallelLinesWhatTheyShare) {
  const auto part = PartBeside(kA, kB, {4'000, 200}, {15'000, 200}, 300);
  ASSERT_TRUE(part);
  EXPECT_DOUBLE_EQ(part->from_nm, 4'000);
  EXPECT_DOUBLE_EQ(part->to_nm, 10'000);
  const auto back = PartBeside(kA, kB, {15'000, -200}, {4'000, -200}, 300);
  ASSERT_TRUE(back);
  EXPECT_DOUBLE_EQ(back->from_nm, 4'000);
  EXPECT_DOUBLE_EQ(back->to_nm, 10'000);
}

TEST(PartBeside, OfALineThatLeansWhatIsNear) {
  const auto part = PartBeside(kA, kB, {0, 0}, {10'000, 1'000}, 300);
  ASSERT_TRUE(part);
  EXPECT_NEAR(part->from_nm, 0, 1e-6);
  EXPECT_NEAR(part->to_nm, 3'000, 1e-6);
}

TEST(PartBeside, NothingFarAwayBeyondOrAcross) {
  EXPECT_FALSE(PartBeside(kA, kB, {0, 400}, {10'000, 400}, 300));
  EXPECT_FALSE(PartBeside(kA, kB, {11'000, 0}, {20'000, 0}, 300));
  EXPECT_FALSE(PartBeside(kA, kB, {5'000, -100}, {5'100, 100}, 300));
  EXPECT_FALSE(PartBeside(kA, kA, {0, 0}, {1'000, 0}, 300));
  EXPECT_FALSE(PartBeside(kA, kB, {500, 0}, {500, 0}, 300));
}

}  // namespace
}  // namespace slicefarm::infill::part_beside_test
