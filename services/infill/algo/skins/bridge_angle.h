#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Direction of lines over an unsupported area, and whether it supports them.
struct BridgeSpan {
  double angle_rad = 0;  ///< direction of the lines, in [0, pi)
  bool held = false;     ///< at least nine tenths of the lines' length are supported at both ends
};

/// Returns the best bridging direction of 36 for lines over the part of `region` that `below` does
/// not support: the one with the shortest 90th-percentile unsupported span. Spans that end in air
/// count tenfold. If no direction has nine tenths of its lines supported at both ends, the
/// directions with the largest supported share, in tenths, are compared. Returns nothing if no part
/// of the region is supported, or the whole region: then any direction is possible.
///
/// Cost: two boolean operations, and O(n) per direction, n points. Source: the idea is Slic3r's
/// bridge detector (lines with both ends on an anchor).
std::optional<BridgeSpan> BridgeAngle(const PolygonWithHoles& region, const MultiPolygon& below,
                                      Coord width_nm);

}  // namespace slicefarm::infill
