#pragma once

#include "common/geometry/polygon.h"

namespace slicefarm::exposure {

/// Which corners are as good as straight.
struct MergeLimits {
  double sagitta = 0;  ///< greatest distance of a corner from its neighbours' chord
  double area = 0;     ///< of all triangles that are cut off or filled in
};

/// Leaves out repeated and straight points, then corners that are nearly straight: within both
/// limits, and with no other corner in the triangle that goes. A reflex corner of a hair's width
/// would otherwise cost a cut, and a sliver beside it. Rings of no area vanish.
/// Cost: O(n), and O(n) for each corner left out.
MultiPolygon MergeCorners(const MultiPolygon& islands, const MergeLimits& limits);

}  // namespace slicefarm::exposure
