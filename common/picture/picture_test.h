#pragma once

#include <cairo.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>

#include "common/picture/colour.h"

namespace slicefarm {

/// A PNG with access to its pixels, for tests.
class Picture {
 public:
  explicit Picture(std::string png) : png_(std::move(png)) {
    surface_ = cairo_image_surface_create_from_png_stream(Read, this);
    EXPECT_EQ(cairo_surface_status(surface_), CAIRO_STATUS_SUCCESS);
  }
  ~Picture() { cairo_surface_destroy(surface_); }

  int width() const { return cairo_image_surface_get_width(surface_); }
  int height() const { return cairo_image_surface_get_height(surface_); }

  /// `pixel`: a vector with x() and y().
  template <typename Pixel>
  Colour At(const Pixel& pixel) const {
    return At(pixel.x(), pixel.y());
  }
  Colour At(double x, double y) const {
    const int row = static_cast<int>(y) * cairo_image_surface_get_stride(surface_);
    uint32_t value = 0;
    std::memcpy(&value, cairo_image_surface_get_data(surface_) + row + 4 * static_cast<int>(x), 4);
    return {(value >> 16 & 255) / 255.0, (value >> 8 & 255) / 255.0, (value & 255) / 255.0};
  }

 private:
  static cairo_status_t Read(void* self, unsigned char* data, unsigned int size) {
    auto* picture = static_cast<Picture*>(self);
    if (picture->at_ + size > picture->png_.size()) return CAIRO_STATUS_READ_ERROR;
    std::memcpy(data, picture->png_.data() + picture->at_, size);
    picture->at_ += size;
    return CAIRO_STATUS_SUCCESS;
  }

  std::string png_;
  size_t at_ = 0;
  cairo_surface_t* surface_;
};

}  // namespace slicefarm
