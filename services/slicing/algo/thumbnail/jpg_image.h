#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "services/slicing/algo/thumbnail/png_image.h"

namespace slicefarm::slicing {

/// Returns the bytes of a JPEG file. Transparent pixels become black, because JPEG has no opacity.
/// REQUIRES: pixels.size() == width * height, row by row from the top. The same pixels give the
/// same bytes. Errors: INTERNAL if libjpeg refuses. Cost: O(pixels).
absl::StatusOr<std::string> EncodeJpg(const std::vector<Rgba>& pixels, int32_t width,
                                      int32_t height);

}  // namespace slicefarm::slicing
