#pragma once

#include <algorithm>
#include <limits>

#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// Extent of a region along the axes of a frame (LineAxes), in nm. If the region is empty, min >
/// max.
struct FrameBox {
  double min_u = std::numeric_limits<double>::max();
  double max_u = std::numeric_limits<double>::lowest();
  double min_v = std::numeric_limits<double>::max();
  double max_v = std::numeric_limits<double>::lowest();
};

/// Returns the extent of a region in a frame.
inline FrameBox BoxIn(const LineAxes& frame, const MultiPolygon& region) {
  FrameBox box;
  for (const PolygonWithHoles& island : region) {
    for (const Point p : island.outer) {
      const double u = frame.U(p), v = frame.V(p);
      box.min_u = std::min(box.min_u, u), box.max_u = std::max(box.max_u, u);
      box.min_v = std::min(box.min_v, v), box.max_v = std::max(box.max_v, v);
    }
  }
  return box;
}

}  // namespace slicefarm::infill
