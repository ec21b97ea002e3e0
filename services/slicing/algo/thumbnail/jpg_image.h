#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/slicing/algo/thumbnail/png_image.h"

namespace slicefarm::slicing {

/// The bytes of a JPEG file, on black where the picture lets the ground through: JPEG knows no
/// opacity. REQUIRES: pixels.size() == width * height, row after row from the top. The same bytes
/// for the same pixels. Errors: INTERNAL if libjpeg refuses. Cost: O(pixels).
absl::StatusOr<std::string> EncodeJpg(const std::vector<Rgba>& pixels, int32_t width,
                                      int32_t height);

}  // namespace slicefarm::slicing
