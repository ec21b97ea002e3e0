#pragma once

#include <optional>

#include "common/geometry/polygon.h"

namespace slicefarm::infill {

/// How lines span what nothing bears.
struct BridgeSpan {
  double angle_rad = 0;  ///< of the lines, in [0, pi)
  bool held = false;     ///< nine tenths of their length, at least, rest on something at both ends
};

/// The direction in which lines over `region` had best span what `below` does not bear: that with
/// the least span for nine tenths of the lines, where spans that end in air count tenfold. Where no
/// direction has nine tenths of the lines on something at both ends, that with the most of them (in
/// tenths) first. Nothing if no part of the region is borne, or all of it: any direction will do.
///
/// Tries 36 directions. Cost: two boolean operations, and O(n) a direction.
/// Source: the idea is Slic3r's bridge detector (lines with both ends on an anchor).
std::optional<BridgeSpan> BridgeAngle(const PolygonWithHoles& region, const MultiPolygon& below,
                                      Coord width_nm);

}  // namespace slicefarm::infill
