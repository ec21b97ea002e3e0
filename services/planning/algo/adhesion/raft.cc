#include "services/planning/algo/adhesion/raft.h"

#include <utility>

#include "common/geometry/offset/offset.h"

namespace slicefarm::planning {
namespace {

MultiPolygon Grown(const MultiPolygon& region, Coord by_nm) {
  return Offset(region, by_nm, {.join = Join::kRound});
}

}  // namespace

std::vector<RaftLayer> RaftUnder(const MultiPolygon& above, const RaftOptions& options) {
  const RaftHeights& heights = options.heights;
  std::vector<RaftLayer> raft;
  if (heights.layers <= 0 || above.empty()) return raft;
  const MultiPolygon top = Grown(above, options.expansion_nm);
  const MultiPolygon middle = heights.layers > 2 ? Grown(top, kRaftStepNm) : MultiPolygon{};
  for (int32_t i = 0; i < heights.layers; ++i) {
    RaftLayer layer;
    layer.print_z_nm = heights.TopOf(i);
    layer.height_nm = heights.HeightOf(i);
    layer.kind = RaftLayerKindOf(i, heights.layers);
    if (i + 1 == heights.layers) {
      layer.region = top;
    } else {
      layer.region = i == 0 ? Grown(top, options.first_layer_expansion_nm) : middle;
    }
    raft.push_back(std::move(layer));
  }
  return raft;
}

}  // namespace slicefarm::planning
