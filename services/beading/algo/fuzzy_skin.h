#pragma once

#include <cstdint>
#include <vector>

#include "common/model/path.h"

namespace slicefarm {
struct BeadingOptions;
}  // namespace slicefarm

namespace slicefarm::beading {

/// Layer of an object. The indices in the job are the seed of the random numbers.
struct SkinContext {
  int32_t object = 0;
  int32_t layer = 0;
  Coord z_nm = 0;       ///< height of the layer's top above the object's bottom
  Coord height_nm = 0;  ///< height of the layer
};

/// Roughens the walls that the setting fuzzy_skin selects. A selected wall gets new points at
/// random distances of 0.75 to 1.25 times fuzzy_skin_point_dist. The noise of the texture is a
/// number in [-1, 1] for each point. Depending on fuzzy_skin_mode, the point moves at right angles
/// to the wall, or the bead there becomes wider or narrower, or both, by up to
/// fuzzy_skin_thickness. If only widths change, the wall keeps its corners. The same walls and
/// context give the same skin. Cost: O(points + length / fuzzy_skin_point_dist).
///
/// Source: measured, PrusaSlicer 2.5 and 2.9. Their skin differs each time.
void Roughen(const BeadingOptions& options, const SkinContext& context, std::vector<Path>& walls);

}  // namespace slicefarm::beading
