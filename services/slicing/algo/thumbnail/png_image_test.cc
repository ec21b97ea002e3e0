#include "services/slicing/algo/thumbnail/png_image.h"

#include <gtest/gtest.h>
#include <png.h>

#include <vector>

namespace slicefarm::slicing::png_image_test {
namespace {

TEST(EncodePng, ComesBackPixelByPixel) {
  std::vector<Rgba> pixels;
  for (int i = 0; i < 5 * 3; ++i)
    pixels.push_back({static_cast<uint8_t>(i * 7), static_cast<uint8_t>(255 - i), 9,
                      static_cast<uint8_t>(i * 17)});
  const auto bytes = EncodePng(pixels, 5, 3);
  ASSERT_TRUE(bytes.ok()) << bytes.status();
  EXPECT_EQ(bytes->substr(0, 4), "\x89PNG");
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&image, bytes->data(), bytes->size()));
  EXPECT_EQ(image.width, 5u);
  EXPECT_EQ(image.height, 3u);
  image.format = PNG_FORMAT_RGBA;
  std::vector<Rgba> read(pixels.size());
  ASSERT_TRUE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr));
  EXPECT_EQ(read, pixels);
}

TEST(EncodePng, RefusesAnEmptyPicture) { EXPECT_FALSE(EncodePng({}, 0, 0).ok()); }

}  // namespace
}  // namespace slicefarm::slicing::png_image_test
