#include "services/slicing/algo/thumbnail/jpg_image.h"

#include <gtest/gtest.h>
#include <jpeglib.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace slicefarm::slicing::jpg_image_test {
namespace {

/// Returns three bytes per pixel. libjpeg ends the test if it cannot read the file.
std::vector<uint8_t> Decode(const std::string& file, uint32_t* width, uint32_t* height) {
  jpeg_decompress_struct jpeg = {};
  jpeg_error_mgr errors = {};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_decompress(&jpeg);
  jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(file.data()), file.size());
  EXPECT_EQ(jpeg_read_header(&jpeg, TRUE), JPEG_HEADER_OK);
  jpeg_start_decompress(&jpeg);
  *width = jpeg.output_width;
  *height = jpeg.output_height;
  std::vector<uint8_t> pixels(size_t{*width} * *height * 3);
  while (jpeg.output_scanline < *height) {
    JSAMPROW row = pixels.data() + size_t{jpeg.output_scanline} * *width * 3;
    jpeg_read_scanlines(&jpeg, &row, 1);
  }
  jpeg_finish_decompress(&jpeg);
  jpeg_destroy_decompress(&jpeg);
  return pixels;
}

TEST(EncodeJpg, IsReadAsTheSamePictureOnBlack) {
  // One half is red, the other half is semi-transparent white.
  std::vector<Rgba> pixels;
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 32; ++x)
      pixels.push_back(x < 16 ? Rgba{200, 30, 20, 255} : Rgba{255, 255, 255, 0});
  const auto file = EncodeJpg(pixels, 32, 24);
  ASSERT_TRUE(file.ok()) << file.status();
  EXPECT_EQ(file->substr(0, 3), "\xff\xd8\xff");
  uint32_t width = 0, height = 0;
  const std::vector<uint8_t> read = Decode(*file, &width, &height);
  ASSERT_EQ(width, 32u);
  ASSERT_EQ(height, 24u);
  for (uint32_t y = 0; y < height; ++y) {
    for (const uint32_t x : {2u, 28u}) {
      const uint8_t* at = &read[(size_t{y} * width + x) * 3];
      EXPECT_NEAR(at[0], x < 16 ? 200 : 0, 6);
      EXPECT_NEAR(at[1], x < 16 ? 30 : 0, 6);
      EXPECT_NEAR(at[2], x < 16 ? 20 : 0, 6);
    }
  }
  EXPECT_EQ(*EncodeJpg(pixels, 32, 24), *file);
}

TEST(EncodeJpg, RefusesAnEmptyPicture) {
  const auto file = EncodeJpg({}, 0, 0);
  EXPECT_EQ(file.status().code(), absl::StatusCode::kInternal);
}

}  // namespace
}  // namespace slicefarm::slicing::jpg_image_test
