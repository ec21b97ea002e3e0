#include "services/coordinator/algo/pipeline/range_split.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "common/base/error.h"
#include "common/stage/object_layers.h"

namespace slicefarm::coordinator {
namespace {

/// Assumed number of slots if no worker has joined yet.
constexpr int kSlotsToCome = 8;

int64_t PointsOf(const SlicedLayer& layer) {
  int64_t points = 0;
  for (const ObjectSection& section : layer.sections) {
    for (const Region& region : section.regions)
      points += static_cast<int64_t>(PointCount(region.outlines));
  }
  return points;
}

}  // namespace

std::vector<LayerRange> SplitIntoRanges(std::span<const SlicedLayer> layers, int slots,
                                        const RangeSplitOptions& options) {
  std::vector<int64_t> costs(layers.size());
  std::transform(layers.begin(), layers.end(), costs.begin(),
                 [&](const SlicedLayer& layer) { return options.layer_points + PointsOf(layer); });
  const int shares = 2 * (slots > 0 ? slots : kSlotsToCome);
  int64_t remaining = std::accumulate(costs.begin(), costs.end(), int64_t{0});

  std::vector<LayerRange> ranges;
  const int32_t count = static_cast<int32_t>(layers.size());
  for (int32_t first = 0; first < count;) {
    const int64_t share = std::min(remaining / shares, options.max_points);
    int32_t last = first;
    int64_t cost = 0;
    while (last < count && last - first < options.max_layers) {
      const bool full = cost + costs[last] > share;
      // A range has fewer than min_layers only if its layers exceed max_points.
      if (full && (last - first >= options.min_layers || cost >= options.max_points)) break;
      cost += costs[last++];
    }
    ranges.push_back({first, last});
    remaining -= cost;
    first = last;
  }
  return ranges;
}

absl::Status CheckNeighbourhoods(std::span<const SlicedLayer> layers,
                                 std::span<const LayerRange> ranges, int32_t halo,
                                 int64_t most_points) {
  std::vector<int64_t> below = {0};  // points below each layer
  for (const SlicedLayer& layer : layers) below.push_back(below.back() + PointsOf(layer));
  for (const LayerRange& range : ranges) {
    const LayerRange grown = WithHalo(layers, range, halo);
    const int64_t points =
        below[static_cast<size_t>(grown.last)] - below[static_cast<size_t>(grown.first)];
    if (points > most_points)
      return LimitError(Reason::kRequestTooLarge,
                        "points of outlines in layers " + std::to_string(grown.first) + " to " +
                            std::to_string(grown.last - 1) +
                            ", which the settings require to be processed together",
                        most_points, points);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
