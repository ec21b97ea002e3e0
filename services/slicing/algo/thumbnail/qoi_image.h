#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "services/slicing/algo/thumbnail/png_image.h"

namespace slicefarm::slicing {

/// The picture as QOI, with opacity: what printers with little memory read. `pixels`: row by row
/// from the top, width * height of them. The same bytes for the same pixels. Cost: O(pixels).
/// Source: "The Quite OK Image Format", specification 1.0 of 2022-01-05.
std::string EncodeQoi(std::span<const Rgba> pixels, int32_t width, int32_t height);

}  // namespace slicefarm::slicing
