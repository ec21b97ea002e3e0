#include "common/gcode/binary/heatshrink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace slicefarm::gcode::heatshrink_test {
namespace {

/// Independent decoder. Returns an empty text for an invalid stream.
std::string Read(const std::string& stream, size_t size) {
  size_t at = 0;
  const auto number = [&](int bits) {
    uint32_t value = 0;
    for (; bits > 0; --bits, ++at)
      value = value << 1 | (static_cast<unsigned char>(stream.at(at / 8)) >> (7 - at % 8) & 1);
    return value;
  };
  std::string bytes;
  while (bytes.size() < size) {
    if (number(1) == 1) {
      bytes += static_cast<char>(number(8));
      continue;
    }
    const size_t back = number(12) + 1;
    const size_t count = number(4) + 1;
    if (back > bytes.size()) return {};
    for (size_t i = 0; i < count; ++i) bytes += bytes[bytes.size() - back];
  }
  EXPECT_LT(stream.size() * 8 - at, 8u);
  return bytes;
}

/// Returns the number of bits of a shortest stream, by testing all matches of all lengths.
size_t FewestBits(const std::string& bytes) {
  std::vector<size_t> bits(bytes.size() + 1, 0);
  for (size_t i = bytes.size(); i-- > 0;) {
    bits[i] = 9 + bits[i + 1];
    for (size_t from = i > 4096 ? i - 4096 : 0; from < i; ++from)
      for (size_t n = 0; n < 16 && i + n < bytes.size() && bytes[from + n] == bytes[i + n]; ++n)
        bits[i] = std::min(bits[i], 17 + bits[i + n + 1]);
  }
  return bits[0];
}

TEST(Heatshrink, IsAsTheFormatSays) {
  EXPECT_EQ(Heatshrink(""), "");
  // 1 01100001, and 7 bits without meaning.
  EXPECT_EQ(Heatshrink("a"), "\xb0\x80");
  // 1 01100001, then 0, a distance of 1, and 9 more bytes.
  EXPECT_EQ(Heatshrink("aaaaaaaaaa"), std::string("\xb0\x80\x02\x00", 4));
}

TEST(Heatshrink, ComesBackAndIsShortest) {
  std::mt19937 random(7);
  for (int i = 0; i < 200; ++i) {
    std::string bytes;
    const uint32_t letters = 1 + random() % 6;
    const size_t size = random() % 400;
    while (bytes.size() < size) bytes += static_cast<char>('0' + random() % letters);
    const std::string stream = Heatshrink(bytes);
    EXPECT_EQ(Read(stream, size), bytes);
    EXPECT_EQ(stream.size(), (FewestBits(bytes) + 7) / 8) << bytes;
  }
}

TEST(Heatshrink, LooksBackThroughItsWholeWindowAndNoFurther) {
  std::mt19937 random(3);
  std::string noise;
  for (int i = 0; i < 6000; ++i) noise += static_cast<char>(random());
  for (const size_t back : {4095u, 4096u, 4097u, 5000u}) {
    const std::string bytes = noise.substr(0, back) + noise.substr(0, 16);
    const std::string stream = Heatshrink(bytes);
    EXPECT_EQ(Read(stream, bytes.size()), bytes);
    const size_t more = stream.size() - Heatshrink(noise.substr(0, back)).size();
    EXPECT_EQ(more <= 3, back <= 4096) << back << ": " << more;
  }
}

TEST(Heatshrink, HoldsItsBoundOnWhatDoesNotRepeat) {
  std::mt19937 random(5);
  std::string noise;
  for (int i = 0; i < 100'000; ++i) noise += static_cast<char>(random());
  const std::string stream = Heatshrink(noise);
  EXPECT_LE(stream.size(), noise.size() * 9 / 8 + 1);
  EXPECT_EQ(Read(stream, noise.size()), noise);
}

}  // namespace
}  // namespace slicefarm::gcode::heatshrink_test
