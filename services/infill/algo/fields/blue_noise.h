#pragma once

#include <cstdint>
#include <vector>

namespace slicefarm::infill {

/// Side of the square of blue-noise thresholds, in cells. The square repeats. At any level, the
/// cells below the level are evenly spread, without clusters and large voids, and each rank occurs
/// once (void and cluster, Ulichney 1993). The thresholds are always the same.
inline constexpr int32_t kBlueNoiseSide = 32;

/// Returns the threshold of any cell, in (0, 1).
double BlueNoiseAt(int64_t column, int64_t row);

/// Returns the order in which the cells of a square of `side` are set, 0 first, from a random start
/// with `seed`. REQUIRES: side >= 4. Cost: O(side^4).
std::vector<int32_t> VoidAndCluster(int32_t side, uint32_t seed);

}  // namespace slicefarm::infill
