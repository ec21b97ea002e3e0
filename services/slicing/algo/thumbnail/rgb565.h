#pragma once

#include <cstdint>

#include "services/slicing/algo/thumbnail/png_image.h"

namespace slicefarm::slicing {

/// Returns a pixel over a background, in 16 bits: 5 of red, 6 of green and 5 of blue.
inline uint16_t ToRgb565(Rgba pixel, Rgba background) {
  const auto over = [&](int own, int under) {
    return (own * pixel[3] + under * (255 - pixel[3])) / 255;
  };
  const int red = over(pixel[0], background[0]), green = over(pixel[1], background[1]),
            blue = over(pixel[2], background[2]);
  return static_cast<uint16_t>((red >> 3) << 11 | (green >> 2) << 5 | blue >> 3);
}

}  // namespace slicefarm::slicing
