#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "services/texture/algo/pattern/height_grid.h"

namespace slicefarm::texture {

struct ImageHeightOptions {
  double width_mm = 20;    ///< of the image; its height keeps the image's shape
  double height_mm = 0.5;  ///< of white; black is 0
};

/// A PNG image as heights: a node a pixel, at its middle; the last column is followed by the first,
/// so that an image that tiles has no seam. Grey of 8 or 16 bits or colour (its luminance); what is
/// transparent is low. Errors: REQUEST_MALFORMED for what is no PNG; REQUEST_TOO_LARGE past
/// kMaxHeightNodes pixels.
absl::StatusOr<HeightGrid> ImageHeights(std::string_view png, const ImageHeightOptions& options);

}  // namespace slicefarm::texture
