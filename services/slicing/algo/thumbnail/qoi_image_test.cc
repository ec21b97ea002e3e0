#include "services/slicing/algo/thumbnail/qoi_image.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace slicefarm::slicing::qoi_image_test {
namespace {

/// Decodes a QOI file chunk by chunk, as the specification defines them.
std::vector<Rgba> Decode(const std::string& file, size_t count) {
  std::vector<Rgba> pixels;
  std::array<Rgba, 64> seen = {};
  Rgba at = {0, 0, 0, 255};
  size_t next = 14;
  const auto byte = [&] { return static_cast<uint8_t>(file.at(next++)); };
  while (pixels.size() < count) {
    const uint8_t tag = byte();
    int repeat = 1;
    if (tag >= 0xfe) {
      for (size_t i = 0; i < (tag == 0xff ? 4u : 3u); ++i) at[i] = byte();
    } else if (tag >> 6 == 0) {
      at = seen[tag];
    } else if (tag >> 6 == 1) {
      at[0] += (tag >> 4 & 3) - 2;
      at[1] += (tag >> 2 & 3) - 2;
      at[2] += (tag & 3) - 2;
    } else if (tag >> 6 == 2) {
      const int green = (tag & 63) - 32;
      const uint8_t others = byte();
      at[0] += green + (others >> 4) - 8;
      at[1] += green;
      at[2] += green + (others & 15) - 8;
    } else {
      repeat = (tag & 63) + 1;
    }
    seen[(at[0] * 3 + at[1] * 5 + at[2] * 7 + at[3] * 11) % 64] = at;
    pixels.insert(pixels.end(), static_cast<size_t>(repeat), at);
  }
  EXPECT_EQ(file.substr(next), std::string("\0\0\0\0\0\0\0\1", 8));
  return pixels;
}

TEST(EncodeQoi, HasItsHeaderAndEnd) {
  const std::vector<Rgba> pixels(6, Rgba{1, 2, 3, 255});
  const std::string file = EncodeQoi(pixels, 3, 2);
  EXPECT_EQ(file.substr(0, 14), std::string("qoif\0\0\0\3\0\0\0\2\4\0", 14));
  EXPECT_EQ(Decode(file, 6), pixels);
}

TEST(EncodeQoi, ReturnsEveryKindOfChunk) {
  const std::vector<Rgba> pixels = {{0, 0, 0, 255},     {1, 255, 1, 255},  {20, 10, 5, 255},
                                    {200, 10, 90, 255}, {200, 10, 90, 7},  {1, 255, 1, 255},
                                    {1, 255, 1, 255},   {30, 255, 1, 255}, {30, 255, 1, 0}};
  EXPECT_EQ(Decode(EncodeQoi(pixels, 9, 1), 9), pixels);
}

TEST(EncodeQoi, ReturnsLongRunsAndNoise) {
  std::mt19937 random(1);
  std::vector<Rgba> pixels(200, Rgba{9, 9, 9, 9});
  for (int i = 0; i < 5000; ++i) {
    Rgba pixel = pixels.back();
    const uint32_t scale = 1u << random() % 9;
    for (uint8_t& channel : pixel)
      if (random() % 2 == 0) channel = static_cast<uint8_t>(channel + random() % scale);
    pixels.push_back(pixel);
  }
  EXPECT_EQ(Decode(EncodeQoi(pixels, 52, 100), pixels.size()), pixels);
}

}  // namespace
}  // namespace slicefarm::slicing::qoi_image_test
