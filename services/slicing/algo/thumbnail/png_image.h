#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::slicing {

/// Pixel: red, green, blue, opacity.
using Rgba = std::array<uint8_t, 4>;

/// Returns the bytes of a PNG file. REQUIRES: pixels.size() == width * height, row by row from the
/// top. Errors: INTERNAL if libpng refuses.
absl::StatusOr<std::string> EncodePng(const std::vector<Rgba>& pixels, int32_t width,
                                      int32_t height);

}  // namespace slicefarm::slicing
