#include "common/picture/cairo_picture.h"

#include <gtest/gtest.h>

#include "common/picture/picture_test.h"

namespace slicefarm::cairo_picture_test {
namespace {

TEST(PngOf, KeepsPixels) {
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, 4, 3));
  const CairoContext context(cairo_create(surface.get()));
  cairo_set_source_rgb(context.get(), 1, 0, 0);
  cairo_rectangle(context.get(), 2, 1, 1, 1);
  cairo_fill(context.get());
  const auto png = PngOf(surface.get());
  ASSERT_TRUE(png.ok()) << png.status();
  const Picture picture(*png);
  EXPECT_EQ(picture.width(), 4);
  EXPECT_EQ(picture.height(), 3);
  EXPECT_EQ(picture.At(2, 1).red, 1);
  EXPECT_EQ(picture.At(1, 1).red, 0);
}

TEST(PngOf, NamesWhatFailed) {
  const CairoSurface none(cairo_image_surface_create(CAIRO_FORMAT_RGB24, -1, 3));
  EXPECT_EQ(PngOf(none.get()).status().code(), absl::StatusCode::kInternal);
}

}  // namespace
}  // namespace slicefarm::cairo_picture_test
