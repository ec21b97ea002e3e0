#pragma once

#include <cstdint>
#include <vector>

#include "common/model/path.h"

namespace slicefarm {
struct BeadingOptions;
}  // namespace slicefarm

namespace slicefarm::beading {

/// Object and layer of a section in the job; the seed of its skin's random numbers.
struct SkinSeed {
  int32_t object = 0;
  int32_t layer = 0;
};

/// Roughens the outermost walls selected by fuzzy_skin. Points are added at random distances of
/// 0.75 to 1.25 times fuzzy_skin_point_dist. Each point is moved at right angles to the wall, by up
/// to fuzzy_skin_thickness in either direction. The same walls and seed give the same skin. Cost:
/// O(points + length / fuzzy_skin_point_dist).
///
/// Source: measured, PrusaSlicer 2.5 and 2.9; their skin differs each time.
void Roughen(const BeadingOptions& options, SkinSeed seed, std::vector<Path>& walls);

}  // namespace slicefarm::beading
