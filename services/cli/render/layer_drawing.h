#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/geometry/vector.h"
#include "common/picture/colour.h"
#include "services/cli/render/gcode_reader.h"

namespace slicefarm::cli {

enum class ImageFormat { kPng, kSvg };
enum class ColourBy {
  kFeature,
  kWidth,
  kSpeed,
  kFlow,
  kTime,    ///< print time, by the firmware's look-ahead (BeadRun::time_s)
  kOrder,   ///< print order: first is dark, last is light
  kEnergy,  ///< number of passes or energy of each pixel (exposure_map.h)
};

/// Options of a picture.
struct DrawingOptions {
  ImageFormat format = ImageFormat::kPng;
  ColourBy colour_by = ColourBy::kFeature;
  int size_px = 1200;    ///< length of the longer side of the part's picture
  bool travels = false;  ///< true to draw travels as thin lines
};

/// Returns the colour of a feature from the text of its `;TYPE:` comment; grey for unknown
/// features.
Colour FeatureColour(std::string_view feature);

/// Layout of the picture: the part to the left, the legend to the right.
struct Layout {
  double left_mm = 0;  ///< x coordinate at the upper left corner of the picture
  double top_mm = 0;
  double px_per_mm = 1;
  int part_width_px = 0;
  int width_px = 0;
  int height_px = 0;

  /// Returns the pixel coordinates of a point in mm.
  Vector2 ToPixel(Vector2 p) const {
    return {(p.x() - left_mm) * px_per_mm, (top_mm - p.y()) * px_per_mm};
  }
};

/// Computes the layout of the picture of a layer.
Layout LayOut(const GcodeLayer& layer, const DrawingOptions& options);

/// Draws the layer from above: every bead with its true width and round ends, in the order of
/// printing, with legend and scale. Errors: Internal if the picture cannot be made. Cost: O(moves).
absl::StatusOr<std::string> DrawLayer(const GcodeLayer& layer, const DrawingOptions& options);

}  // namespace slicefarm::cli
