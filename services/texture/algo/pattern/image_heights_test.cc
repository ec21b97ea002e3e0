#include "services/texture/algo/pattern/image_heights.h"

#include <gtest/gtest.h>
#include <png.h>

#include <string>
#include <vector>

#include "common/base/error.h"

namespace slicefarm::texture::image_heights_test {
namespace {

/// Returns a PNG of `format` with these bytes.
std::string PngOf(uint32_t width, uint32_t height, uint32_t format,
                  const std::vector<uint8_t>& bytes) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = format;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, bytes.data(), 0, nullptr);
  std::string png(size, '\0');
  png_image_write_to_memory(&image, png.data(), &size, 0, bytes.data(), 0, nullptr);
  png.resize(size);
  return png;
}

TEST(ImageHeights, GreyIsHeightAndTheFirstRowIsOnTop) {
  const auto grid = ImageHeights(PngOf(3, 2, PNG_FORMAT_GRAY, {0, 51, 255, 102, 204, 153}),
                                 {.width_mm = 6, .height_mm = 2});
  ASSERT_TRUE(grid.ok()) << grid.status();
  EXPECT_EQ(grid->columns, 3);
  EXPECT_EQ(grid->rows, 2);
  EXPECT_EQ(grid->size_mm, Eigen::Vector2d(6, 4));
  const double want[] = {0.8, 1.6, 1.2, 0, 0.4, 2};
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(grid->heights_mm[i], want[i], 1e-12) << i;
}

TEST(ImageHeights, TakesColourAndTransparency) {
  const auto colour = ImageHeights(PngOf(1, 1, PNG_FORMAT_RGB, {255, 0, 0}), {.height_mm = 1});
  ASSERT_TRUE(colour.ok()) << colour.status();
  EXPECT_NEAR(colour->heights_mm[0], 0.2126, 1e-9);
  const auto clear = ImageHeights(PngOf(1, 1, PNG_FORMAT_GA, {255, 0}), {.height_mm = 1});
  ASSERT_TRUE(clear.ok()) << clear.status();
  EXPECT_EQ(clear->heights_mm[0], 0);
}

TEST(ImageHeights, RefusesWhatIsNoImage) {
  const std::string good = PngOf(4, 4, PNG_FORMAT_GRAY, std::vector<uint8_t>(16, 7));
  for (size_t length = 0; length + 12 < good.size(); ++length) {  // up to the end marker
    const auto grid = ImageHeights(std::string_view(good).substr(0, length), {});
    ASSERT_FALSE(grid.ok()) << length;
    EXPECT_EQ(DetailOf(grid.status()).reason, Reason::kRequestMalformed);
  }
  std::string wide = good;
  wide[16] = wide[20] = 0x7f;  // the header's width and height
  EXPECT_FALSE(ImageHeights(wide, {}).ok());
}

}  // namespace
}  // namespace slicefarm::texture::image_heights_test
