#pragma once

#include <string_view>

#include "absl/status/statusor.h"
#include "services/texture/algo/pattern/height_grid.h"

namespace slicefarm::texture {

/// Options for ImageHeights.
struct ImageHeightOptions {
  double width_mm = 20;    ///< width of the image; its length follows from the image's proportions
  double height_mm = 0.5;  ///< height of white pixels; black pixels have height 0
};

/// Returns a PNG image as a height grid, with one node at the middle of each pixel. The grid is
/// periodic: the first column follows the last one. So an image that tiles has no seam. The image
/// may be grey with 8 or 16 bits, or in colour (its luminance counts); transparent pixels are low.
/// Errors: REQUEST_MALFORMED for data that are no PNG; REQUEST_TOO_LARGE above kMaxHeightNodes
/// pixels.
absl::StatusOr<HeightGrid> ImageHeights(std::string_view png, const ImageHeightOptions& options);

}  // namespace slicefarm::texture
