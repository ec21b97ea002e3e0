#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

struct RangeSplitOptions {
  int32_t min_layers = 8;        ///< below, a call costs more than it is worth
  int32_t max_layers = 128;      ///< above, too much is lost with a worker
  int64_t max_points = 100'000;  ///< of the outlines; bounds what a slot holds in memory
  int64_t layer_points = 100;    ///< what a layer costs besides its own
};

/// Cuts a job into contiguous ranges for `slots` workers: each takes 1 / (2 slots) of the outline
/// points that remain, so the first are long and the last are short, and all workers end at about
/// the same time. The G-code does not depend on the cut.
///
/// Shapes: the ranges cover [0, layers.size()) without gap or overlap, in order; none is empty.
/// Cost:   O(points' rings).
std::vector<LayerRange> SplitIntoRanges(std::span<const SlicedLayer> layers, int slots,
                                        const RangeSplitOptions& options = {});

/// Of outlines: what a call for a range of layers may look at, the range's and its halo's.
inline constexpr int64_t kMaxPointsPerRange = 20'000'000;

/// Whether each range with `halo` layers on either side is small enough for a worker: the settings
/// may ask for a halo that is the whole job. Errors: REQUEST_TOO_LARGE with `limit` and `got`, in
/// points of outlines. Cost: O(rings + ranges).
absl::Status CheckNeighbourhoods(std::span<const SlicedLayer> layers,
                                 std::span<const LayerRange> ranges, int32_t halo,
                                 int64_t most_points = kMaxPointsPerRange);

}  // namespace slicefarm::coordinator
