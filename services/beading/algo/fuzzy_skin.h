#pragma once

#include <cstdint>
#include <vector>

#include "common/model/path.h"

namespace slicefarm {
struct BeadingOptions;
}  // namespace slicefarm

namespace slicefarm::beading {

/// Indices of an object and of a layer in the job; the seed of the random numbers.
struct SkinSeed {
  int32_t object = 0;
  int32_t layer = 0;
};

/// Roughens the walls that the setting fuzzy_skin selects. A selected wall gets new points at
/// random distances of 0.75 to 1.25 times fuzzy_skin_point_dist. Each point is moved at right
/// angles to the wall, by up to fuzzy_skin_thickness in either direction. The same walls and seed
/// give the same skin. Cost: O(points + length / fuzzy_skin_point_dist).
///
/// Source: measured, PrusaSlicer 2.5 and 2.9. Their skin differs each time.
void Roughen(const BeadingOptions& options, SkinSeed seed, std::vector<Path>& walls);

}  // namespace slicefarm::beading
