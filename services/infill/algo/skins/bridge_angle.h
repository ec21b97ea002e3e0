#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Direction of lines over an unsupported area.
struct BridgeSpan {
  double angle_rad = 0;  ///< direction of the lines, in [0, pi)
  /// true if the lines' ends are supported: both ends, for at least nine tenths of the length
  bool held = false;
};

/// Returns the best bridging direction of 36 for lines over the part of `region` that `below` does
/// not support: the direction with the shortest 90th-percentile span. A span is the unsupported
/// part of one line; its length counts tenfold if one of its ends is not supported. If no direction
/// is `held` (BridgeSpan), only directions with the largest supported share, in tenths, are
/// compared. Returns nullopt if no part of the region is supported, or if the whole region is: then
/// any direction is possible. `width_nm`: width of the lines.
///
/// Cost: two boolean operations, and O(n) per direction, n points. Source: the idea is Slic3r's
/// bridge detector (lines with both ends on an anchor).
std::optional<BridgeSpan> BridgeAngle(const PolygonWithHoles& region, const MultiPolygon& below,
                                      Coord width_nm);

}  // namespace slicefarm::infill
