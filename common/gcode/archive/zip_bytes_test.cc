#include "common/gcode/archive/zip_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace slicefarm::gcode::zip_bytes_test {
namespace {

using testing::HasSubstr;

std::string ZipOrDie(const std::vector<ZipMember>& members) {
  auto zip = ZipOf(members);
  EXPECT_TRUE(zip.ok()) << zip.status();
  return zip.ok() ? *std::move(zip) : "";
}

const std::vector<ZipMember> kMembers = {{"a/b.txt", std::string(100'000, 'x')},
                                         {"c.png", "\x89PNG\0\x01", false},
                                         {"empty", ""},
                                         {"ä &.txt", "umlaut"}};

TEST(ZipBytes, MembersComeBackInTheirOrder) {
  const std::string zip = ZipOrDie(kMembers);
  EXPECT_LT(zip.size(), 2'000u) << "text is deflated";
  const auto entries = ZipEntries(zip);
  ASSERT_TRUE(entries.ok()) << entries.status();
  ASSERT_EQ(entries->size(), kMembers.size());
  for (size_t i = 0; i < kMembers.size(); ++i) {
    EXPECT_EQ((*entries)[i].name, kMembers[i].name);
    EXPECT_EQ(*ZipData(zip, (*entries)[i]), kMembers[i].data);
  }
}

TEST(ZipBytes, AreAlikeAtAnyTime) {
  const std::string zip = ZipOrDie(kMembers);
  EXPECT_EQ(ZipOrDie(kMembers), zip);
  // Time and date of the first member: midnight of 1980-01-01.
  EXPECT_EQ(zip.substr(10, 4), std::string("\0\0\x21\0", 4));
}

TEST(ZipBytes, DamagedArchivesAreErrors) {
  const std::string zip = ZipOrDie(kMembers);
  for (const size_t size : {size_t{3}, zip.size() / 2, zip.size() - 1})
    EXPECT_FALSE(ZipEntries(zip.substr(0, size)).ok()) << size;
  const auto entries = ZipEntries(zip);
  ASSERT_TRUE(entries.ok());
  const size_t begin = 30 + entries->front().name.size();  // after the local header
  for (size_t i = 0; i < entries->front().packed_bytes; ++i) {
    std::string flipped = zip;
    flipped[begin + i] ^= 1;
    const auto data = ZipData(flipped, entries->front());
    EXPECT_TRUE(!data.ok() || *data == kMembers[0].data) << i;
  }
  std::string flipped = zip;
  flipped[zip.find("PNG")] ^= 1;  // a stored member
  EXPECT_FALSE(ZipData(flipped, (*entries)[1]).ok());
}

TEST(ZipBytes, BombsAreErrors) {
  const std::string bomb = ZipOrDie({{"bomb", std::string(4 << 20, '\0')}});
  const auto entries = ZipEntries(bomb);
  ASSERT_TRUE(entries.ok());
  EXPECT_TRUE(ZipData(bomb, entries->front()).ok()) << "a ratio of 1000 is usual for zeros";
  ZipEntryInfo claim = entries->front();
  claim.packed_bytes = 10;
  const auto data = ZipData(bomb, claim);
  ASSERT_FALSE(data.ok());
  EXPECT_THAT(std::string(data.status().message()), HasSubstr("bomb in the archive claims"));
  claim = entries->front();
  claim.bytes -= 1;
  EXPECT_FALSE(ZipData(bomb, claim).ok());
  claim.bytes += 2;
  EXPECT_FALSE(ZipData(bomb, claim).ok());
}

TEST(ZipBytes, TooManyEntriesAreAnError) {
  std::vector<ZipMember> members;
  for (int i = 0; i <= kMaxZipEntries; ++i) members.push_back({std::to_string(i), "", false});
  EXPECT_THAT(std::string(ZipEntries(ZipOrDie(members)).status().message()),
              HasSubstr("at most 10000"));
}

}  // namespace
}  // namespace slicefarm::gcode::zip_bytes_test
