#pragma once

#include <cstdint>
#include <vector>

#include "common/model/path.h"

namespace slicefarm {
struct BeadingOptions;
}  // namespace slicefarm

namespace slicefarm::beading {

/// Where a section lies in the job: what its skin's random numbers are drawn from.
struct SkinSeed {
  int32_t object = 0;
  int32_t layer = 0;
};

/// Gives the outermost walls that fuzzy_skin asks for a rough skin: points at random distances of
/// 0.75 to 1.25 times fuzzy_skin_point_dist, each moved at right angles to the wall by up to
/// fuzzy_skin_thickness either way. The same walls and seed give the same skin.
/// Cost: O(points + length / distance).
/// Source: measured, PrusaSlicer 2.5 and 2.9; theirs differs from run to run.
void Roughen(const BeadingOptions& options, SkinSeed seed, std::vector<Path>& walls);

}  // namespace slicefarm::beading
