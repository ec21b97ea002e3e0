#pragma once

#include <cstdint>
#include <vector>

namespace slicefarm::infill {

/// Thresholds of blue noise on a square of kBlueNoiseSide cells, which repeats: at any level, the
/// cells below it lie evenly spread, without clusters and large voids, and each rank occurs once
/// (void and cluster, Ulichney 1993). Always the same ones.
inline constexpr int32_t kBlueNoiseSide = 32;

/// In (0, 1), for cells anywhere.
double BlueNoiseAt(int64_t column, int64_t row);

/// The order in which cells of a square of `side` are set, 0 first, from a random start made of
/// `seed`. REQUIRES: side >= 4. Cost: O(side^4).
std::vector<int32_t> VoidAndCluster(int32_t side, uint32_t seed);

}  // namespace slicefarm::infill
