#pragma once

#include <cstdint>
#include <string_view>

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// Outlines that geometry fails on: what is almost collinear, almost touching or almost nothing.
struct HostileOutline {
  std::string_view kind;
  MultiPolygon islands;
};

/// The same for the same seed, on any machine; seeds in a row go through all kinds. Some hundred
/// points within 200 mm.
HostileOutline MakeHostileOutline(uint64_t seed);

/// A ring with waves on both sides, 100 mm wide: smooth, `points` points in all.
PolygonWithHoles WavyRing(int points);

}  // namespace slicefarm::beading
