#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "absl/status/status.h"
#include "common/model/layers/layer.h"

namespace slicefarm::coordinator {

/// Limits of the ranges of a job.
struct RangeSplitOptions {
  /// Fewest layers of a range; for fewer, the overhead of the call is too large.
  int32_t min_layers = 8;
  /// Largest number of layers of a range; with more, too much work is lost when a worker dies.
  int32_t max_layers = 128;
  /// Largest number of outline points of a range; limits the memory of a slot.
  int64_t max_points = 100'000;
  /// Overhead of a layer that is added to its number of outline points, in points.
  int64_t layer_points = 100;
};

/// Cuts a job into contiguous ranges of layers for `slots` workers. Each range gets 1 / (2 slots)
/// of the outline points that remain at that moment. So the first ranges are long and the last are
/// short, and all workers end at about the same time. The G-code does not depend on the cut.
///
/// Shapes: the ranges cover [0, layers.size()) without gap or overlap, in order; none is empty.
/// Cost: O(number of rings of the layers).
std::vector<LayerRange> SplitIntoRanges(std::span<const SlicedLayer> layers, int slots,
                                        const RangeSplitOptions& options = {});

/// Largest number of outline points in one call for a range, including the range's halo (the
/// neighbour layers that are sent with it).
inline constexpr int64_t kMaxPointsPerRange = 20'000'000;

/// Checks that each range, together with `halo` layers below and above it, is small enough for a
/// worker. The settings may request a halo as large as the whole job. Errors: REQUEST_TOO_LARGE
/// with `limit` and `got`, in outline points. Cost: O(rings of the layers + ranges).
absl::Status CheckNeighbourhoods(std::span<const SlicedLayer> layers,
                                 std::span<const LayerRange> ranges, int32_t halo,
                                 int64_t most_points = kMaxPointsPerRange);

}  // namespace slicefarm::coordinator
