#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "services/slicing/algo/thumbnail/png_image.h"

namespace slicefarm::slicing {

/// Returns the picture as the lines of text that touch screens of BigTreeTech read: the size, then
/// one line for each row, with four hexadecimal digits (RGB565) for each pixel. Transparent pixels
/// are black. `pixels`: row by row from the top, width * height of them. Cost: O(pixels).
std::string EncodeBtt(std::span<const Rgba> pixels, int32_t width, int32_t height);

}  // namespace slicefarm::slicing
