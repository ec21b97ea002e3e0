#include "tests/load/generator/client/part_supply.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "common/base/sha256.h"

namespace slicefarm::load::part_supply_test {
namespace {

TEST(PartSupply, PartsAreOthersEachTime) {
  PartSupply supply({.mix = Mix::kTiny, .seed = 3});
  std::set<std::string> digests;
  for (int i = 0; i < 1000; ++i) {
    const PartPtr part = supply.Take();
    ASSERT_EQ(part->sha256, Sha256Hex(part->bytes));
    digests.insert(part->sha256);
  }
  EXPECT_EQ(digests.size(), 1000u);
  EXPECT_TRUE(supply.SameParts().empty());
}

TEST(PartSupply, TheSeedDecides) {
  PartSupply one({.mix = Mix::kMedium, .seed = 3});
  PartSupply other({.mix = Mix::kMedium, .seed = 3});
  for (int i = 0; i < 20; ++i) EXPECT_EQ(one.Take()->sha256, other.Take()->sha256);
}

TEST(PartSupply, SameIsOnePartOfEachSize) {
  PartSupply supply({.mix = Mix::kMixed, .same = true, .seed = 3});
  std::set<std::string> announced;
  for (const PartPtr& part : supply.SameParts()) announced.insert(part->sha256);
  EXPECT_EQ(announced.size(), 3u);
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(announced.contains(supply.Take()->sha256));
}

}  // namespace
}  // namespace slicefarm::load::part_supply_test
