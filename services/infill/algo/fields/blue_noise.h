#pragma once

#include <cstdint>
#include <vector>

namespace slicefarm::infill {

/// Side of the square of blue-noise thresholds, in cells. The square repeats over the plane. Each
/// threshold occurs once in it, and the thresholds are always the same. For any level, the cells
/// with a threshold below the level are evenly spread, without clusters and large voids (void and
/// cluster, Ulichney 1993).
inline constexpr int32_t kBlueNoiseSide = 32;

/// Returns the threshold of a cell, in (0, 1). Any column and row are allowed, also negative ones.
double BlueNoiseAt(int64_t column, int64_t row);

/// Returns the rank of each cell of a square of `side` x `side` cells, row by row. The rank is the
/// cell's position in the order in which the void-and-cluster method sets the cells, 0 first. The
/// start is random, with `seed`. REQUIRES: side >= 4. Cost: O(side^4).
std::vector<int32_t> VoidAndCluster(int32_t side, uint32_t seed);

}  // namespace slicefarm::infill
