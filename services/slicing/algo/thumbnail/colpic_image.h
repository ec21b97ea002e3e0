#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "services/slicing/algo/thumbnail/png_image.h"

namespace slicefarm::slicing {

/// Returns the picture as the text of the format ColPic, which screens of Elegoo and Qidi read: a
/// head of 32 bytes, a palette of at most 1024 colours (RGB565) and runs of pixels, six bits in
/// each character. Rarer colours become the nearest colour of the palette. Transparent pixels get
/// the screens' background. `pixels`: row by row from the top, width * height of them. REQUIRES:
/// width and height are at least 1. Cost: O(pixels + colours * 1024).
std::string EncodeColPic(std::span<const Rgba> pixels, int32_t width, int32_t height);

}  // namespace slicefarm::slicing
