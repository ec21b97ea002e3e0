#include "services/coordinator/algo/pipeline/range_split.h"

#include <algorithm>
#include <numeric>

namespace slicefarm::coordinator {
namespace {

/// For how many slots to cut while no worker has joined yet.
constexpr int kSlotsToCome = 8;

int64_t WorkIn(const SlicedLayer& layer, const RangeSplitOptions& options) {
  int64_t cost = options.layer_points;
  for (const ObjectSection& section : layer.sections) {
    for (const Region& region : section.regions)
      cost += static_cast<int64_t>(PointCount(region.outlines));
  }
  return cost;
}

}  // namespace

std::vector<LayerRange> SplitIntoRanges(std::span<const SlicedLayer> layers, int slots,
                                        const RangeSplitOptions& options) {
  std::vector<int64_t> costs(layers.size());
  std::transform(layers.begin(), layers.end(), costs.begin(),
                 [&](const SlicedLayer& layer) { return WorkIn(layer, options); });
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
      // A range may be shorter than min_layers only where its layers are huge.
      if (full && (last - first >= options.min_layers || cost >= options.max_points)) break;
      cost += costs[last++];
    }
    ranges.push_back({first, last});
    remaining -= cost;
    first = last;
  }
  return ranges;
}

}  // namespace slicefarm::coordinator
