#pragma once

#include <cstdint>
#include <vector>

namespace slicefarm::infill {

/// Side of the square of blue-noise thresholds, in cells. The square repeats. The cells with
/// thresholds below any level are evenly spread, without clusters and large voids, and each
/// threshold occurs once (void and cluster, Ulichney 1993). The thresholds are always the same.
inline constexpr int32_t kBlueNoiseSide = 32;

/// Returns the threshold of any cell, in (0, 1).
double BlueNoiseAt(int64_t column, int64_t row);

/// Returns the rank of each cell of a square of `side` x `side` cells, in the order in which the
/// void-and-cluster method sets them, 0 first. The start is random, with `seed`. REQUIRES: side >=
/// 4. Cost: O(side^4).
std::vector<int32_t> VoidAndCluster(int32_t side, uint32_t seed);

}  // namespace slicefarm::infill
