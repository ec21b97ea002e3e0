#pragma once

#include <cstdint>
#include <string_view>

#include "common/geometry/polygon.h"

namespace slicefarm::beading {

/// Outline that is difficult for geometry: almost collinear, almost touching or almost empty.
struct HostileOutline {
  std::string_view kind;
  MultiPolygon islands;
};

/// Returns an outline that depends only on the seed, on any machine. Consecutive seeds cover all
/// kinds. It has some hundred points within 200 mm.
HostileOutline MakeHostileOutline(uint64_t seed);

/// Returns a ring with waves on both sides, 100 mm wide and smooth, with `points` points in total.
PolygonWithHoles WavyRing(int points);

}  // namespace slicefarm::beading
