#pragma once

#include <string>
#include <string_view>

#include "absl/status/statusor.h"
#include "common/geometry/vector.h"
#include "common/picture/colour.h"
#include "services/cli/render/gcode_layer.h"

namespace slicefarm::cli {

enum class ImageFormat { kPng, kSvg };
enum class ColourBy {
  kFeature,
  kWidth,
  kSpeed,
  kFlow,
  kTime,    ///< when it is laid, by the firmware's look-ahead (BeadRun::time_s)
  kOrder,   ///< what comes first is dark, what comes last is light
  kEnergy,  ///< how often a place is passed over (exposure_map.h)
};

struct DrawingOptions {
  ImageFormat format = ImageFormat::kPng;
  ColourBy colour_by = ColourBy::kFeature;
  int size_px = 1200;    ///< of the longer side of the part's picture
  bool travels = false;  ///< as thin lines
};

/// Of a feature by the words of its `;TYPE:` comment; grey for words nobody knows.
Colour FeatureColour(std::string_view feature);

/// Where things lie in the picture: the part to the left, the legend to the right.
struct Layout {
  double left_mm = 0;  ///< of the picture's upper left corner
  double top_mm = 0;
  double px_per_mm = 1;
  int part_width_px = 0;
  int width_px = 0;
  int height_px = 0;

  Vector2 ToPixel(Vector2 p) const {
    return {(p.x() - left_mm) * px_per_mm, (top_mm - p.y()) * px_per_mm};
  }
};

Layout LayOut(const GcodeLayer& layer, const DrawingOptions& options);

/// The layer seen from above: every bead with its true width and round ends, in the order of
/// printing, with legend and scale. Errors: Internal if the picture cannot be made. Cost: O(moves).
absl::StatusOr<std::string> DrawLayer(const GcodeLayer& layer, const DrawingOptions& options);

}  // namespace slicefarm::cli
