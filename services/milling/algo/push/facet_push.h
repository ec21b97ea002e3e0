#pragma once

#include <array>
#include <cstdint>

#include "common/model/options/cutter.h"
#include "services/milling/algo/push/edge_push.h"

namespace slicefarm::milling {

/// Where the cutter touches the inside of a triangle: it does so on one side only, on that to which
/// the triangle falls.
struct FacetContact {
  int8_t side = 0;  ///< 1: the end is a high one; -1: a low one; 0: there is none
  double end = 0;
  FiberPoint at;
};

/// What does not change along the fibers of an axis: a normal of length 1, turned upwards.
struct FacetNormal {
  double along = 0;
  double across = 0;
  double up = 0;
  double flat = 0;  ///< length of its horizontal part; 0: level, or no area
};

FacetNormal NormalOf(const std::array<FiberPoint, 3>& corners);

/// A plane of a slope is touched at one height above the tip (Cutter::TouchHeight): on the line in
/// which the triangle is cut there, with the cutter's axis down the slope from it. Level and
/// upright triangles are touched by their edges alone. Cost: 15 ns.
FacetContact PushFacet(const Cutter& cutter, const std::array<FiberPoint, 3>& corners,
                       const FacetNormal& normal);

}  // namespace slicefarm::milling
