#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "services/slicing/algo/thumbnail/png_image.h"

namespace slicefarm::slicing {

/// Returns the picture as QOI with opacity, a format for printers with little memory. `pixels`: row
/// by row from the top, width * height of them. REQUIRES: width >= 1, height >= 1. The same pixels
/// give the same bytes. Cost: O(pixels).
std::string EncodeQoi(std::span<const Rgba> pixels, int32_t width, int32_t height);

}  // namespace slicefarm::slicing
