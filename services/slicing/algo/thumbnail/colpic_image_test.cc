#include "services/slicing/algo/thumbnail/colpic_image.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "services/slicing/algo/thumbnail/rgb565.h"

namespace slicefarm::slicing::colpic_image_test {
namespace {

/// Returns the bytes of a text with six bits in each character.
std::vector<uint8_t> BytesOf(const std::string& text) {
  std::vector<uint8_t> bytes;
  EXPECT_EQ(text.size() % 4, 0u);
  for (size_t i = 0; i < text.size(); i += 4) {
    uint32_t group = 0;
    for (size_t k = 0; k < 4; ++k) {
      const char letter = text[i + k] == '~' ? '\\' : text[i + k];
      EXPECT_TRUE('0' <= letter && letter < '0' + 64) << letter;
      group = group << 6 | static_cast<uint32_t>(letter - '0');
    }
    for (int shift = 16; shift >= 0; shift -= 8)
      bytes.push_back(static_cast<uint8_t>(group >> shift & 0xFF));
  }
  return bytes;
}

struct Picture {
  uint32_t width = 0, height = 0, colours = 0;
  std::vector<uint16_t> pixels;
};

/// Reads a picture as a screen does: head, palette, runs.
Picture Decode(const std::string& text) {
  const std::vector<uint8_t> bytes = BytesOf(text);
  const auto number = [&](size_t at, size_t size) {
    uint32_t value = 0;
    for (size_t i = 0; i < size; ++i) value |= uint32_t{bytes.at(at + i)} << (8 * i);
    return value;
  };
  EXPECT_EQ(bytes.at(0), 3);
  EXPECT_EQ(number(12, 4), 0x05DDC33Cu);
  Picture picture{number(4, 4), number(8, 4), number(16, 4) / 2, {}};
  const size_t palette = 32, runs = palette + number(16, 4), end = runs + number(20, 4);
  size_t bank = 0;
  for (size_t at = runs; at < end; ++at) {
    size_t count = bytes.at(at) >> 5;
    const size_t low = bytes.at(at) & 31;
    if (count == 7) {
      bank = low;
      continue;
    }
    if (count == 0) count = bytes.at(++at);
    const auto colour = static_cast<uint16_t>(number(palette + 2 * (32 * bank + low), 2));
    picture.pixels.insert(picture.pixels.end(), count, colour);
  }
  return picture;
}

std::vector<uint16_t> Reduced(const std::vector<Rgba>& pixels) {
  std::vector<uint16_t> reduced;
  for (const Rgba& pixel : pixels) reduced.push_back(ToRgb565(pixel, {46, 51, 72, 255}));
  return reduced;
}

TEST(EncodeColPic, AScreenReadsTheSamePixels) {
  std::mt19937 random(1);
  for (const auto& [width, height, colours] :
       {std::tuple{1, 1, 1}, {20, 30, 3}, {64, 64, 40}, {100, 100, 900}}) {
    std::vector<Rgba> pixels;
    while (std::ssize(pixels) < width * height) {
      const auto colour = static_cast<uint8_t>(random() % static_cast<unsigned>(colours) / 4);
      const auto shade = static_cast<uint8_t>(random() % static_cast<unsigned>(colours));
      const size_t run = 1 + random() % 300;
      for (size_t i = 0; i < run && std::ssize(pixels) < width * height; ++i)
        pixels.push_back({colour, shade, 100, 255});
    }
    const Picture picture = Decode(EncodeColPic(pixels, width, height));
    EXPECT_EQ(picture.width, static_cast<uint32_t>(width));
    EXPECT_EQ(picture.height, static_cast<uint32_t>(height));
    EXPECT_EQ(picture.pixels, Reduced(pixels));
  }
}

TEST(EncodeColPic, TransparentPixelsAreTheBackground) {
  const Picture picture = Decode(EncodeColPic(std::vector<Rgba>(9, {200, 10, 10, 0}), 3, 3));
  EXPECT_EQ(picture.pixels, std::vector<uint16_t>(9, ToRgb565({46, 51, 72, 255}, {})));
  EXPECT_EQ(picture.colours, 1u);
}

TEST(EncodeColPic, RareColoursBecomeTheNearestOfThePalette) {
  std::vector<Rgba> pixels;
  for (int red = 0; red < 32; ++red)
    for (int green = 0; green < 64; ++green)
      pixels.push_back({static_cast<uint8_t>(8 * red), static_cast<uint8_t>(4 * green), 0, 255});
  const Picture picture = Decode(EncodeColPic(pixels, 64, 32));
  EXPECT_EQ(picture.colours, 1024u);
  ASSERT_EQ(picture.pixels.size(), pixels.size());
  const std::vector<uint16_t> wanted = Reduced(pixels);
  for (size_t i = 0; i < wanted.size(); ++i) {
    const int red = (picture.pixels[i] >> 11) - (wanted[i] >> 11);
    EXPECT_LE(std::abs(red), 16) << i;
  }
}

}  // namespace
}  // namespace slicefarm::slicing::colpic_image_test
