#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// Direction of lines over an unsupported area, and their support.
struct BridgeSpan {
  double angle_rad = 0;  ///< direction of the lines, in [0, pi)
  bool held = false;     ///< at least nine tenths of their length are supported at both ends
};

/// Returns the best bridging direction of 36 for lines over the part of `region` that `below` does
/// not support: the one with the shortest 90th-percentile unsupported span. Spans that end in air
/// count tenfold. If in no direction nine tenths of the lines are supported at both ends, the
/// direction with the most supported tenths is chosen first. Returns nothing if no part of the
/// region is supported, or the whole region: then any direction is possible.
///
/// Cost: two boolean operations, and O(n) per direction. Source: the idea is Slic3r's bridge
/// detector (lines with both ends on an anchor).
std::optional<BridgeSpan> BridgeAngle(const PolygonWithHoles& region, const MultiPolygon& below,
                                      Coord width_nm);

}  // namespace slicefarm::infill
