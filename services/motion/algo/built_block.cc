#include "services/motion/algo/built_block.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "services/motion/algo/toolpath/contour_length.h"
#include "services/motion/algo/toolpath/flow_smoothing.h"
#include "services/motion/algo/toolpath/move_arcs.h"
#include "services/motion/algo/toolpath/print_speed.h"

namespace slicefarm::motion {
namespace {

Ground GroundOf(const LayerFrame& frame, const PathBlock& block) {
  if (frame.index == 0) return Ground::kBed;
  return block.stack.IsPart() && block.layer == 0 ? Ground::kRaft : Ground::kLayers;
}

/// Returns true if the block is the layer's first one and the layer begins with the filament ready.
bool BeginsReady(const PathBlock& block, const OrderedLayer& layer) {
  return layer.begins_ready && !layer.visits.empty() &&
         &block == &BlockOf(layer.visits.front(), layer);
}
bool EndsReady(const PathBlock& block, const OrderedLayer& layer) {
  return layer.ends_ready && !layer.visits.empty() &&
         &block == &BlockOf(layer.visits.back(), layer);
}

/// Returns true if only the first visit of the layer prints the block.
bool IsOnlyFirst(const PathBlock& block, const OrderedLayer& layer) {
  const auto prints = [&](const BlockVisit& visit) { return &BlockOf(visit, layer) == &block; };
  return !layer.visits.empty() && prints(layer.visits.front()) &&
         std::ranges::count_if(layer.visits, prints) == 1;
}

}  // namespace

std::vector<BuiltBlock> BuildBlocks(const OrderedLayer& layer, const MotionOptions& options,
                                    double retracted_mm) {
  const FlowSlopes slopes = {options.flow_rise_mm3_s2, options.flow_fall_mm3_s2,
                             options.flow_segment_mm, options.flow_slopes_of_outer_walls};
  std::vector<BuiltBlock> built;
  built.reserve(layer.blocks.size());
  for (const PathBlock& block : layer.blocks) {
    std::optional<LayerBelow> below;
    if (!block.below.empty() && LooksBelow(options)) below.emplace(block.below);
    std::optional<LayerBelow> above_supports;
    if (below && !block.above_supports.empty()) above_supports.emplace(block.above_supports);
    std::optional<LayerBelow> curled;
    if (below && !block.curled.empty()) curled.emplace(block.curled);
    ToolpathBuilder builder(options, layer.frame, block.height_nm, GroundOf(layer.frame, block),
                            below ? &*below : nullptr, above_supports ? &*above_supports : nullptr,
                            curled ? &*curled : nullptr);
    std::optional<SurfaceFollower> follower;
    if (!block.surface.empty()) {
      follower.emplace(block.surface, block.height_nm, FromMm(options.tool().nozzle_diameter_mm));
      builder.FollowSurface(&*follower);
    }
    if (IsOnlyFirst(block, layer)) builder.BeginRetracted(retracted_mm);
    if (BeginsReady(block, layer)) builder.BeginAsLeft();
    if (block.spiral && block.paths.size() == 1) {
      builder.AddTurn(block.paths.front(), *block.spiral, block.below);
    } else {
      const std::vector<double> lengths_mm = ContourLengthsMm(block.paths);
      for (size_t i = 0; i < block.paths.size(); ++i)
        builder.Add(block.paths[i], block.travels.empty() ? Travel{} : block.travels[i],
                    lengths_mm[i]);
    }
    Toolpath path =
        EndsReady(block, layer) ? builder.FinishAt(block.exit_travel) : builder.Finish();
    if (slopes.rise_mm3_s2 > 0 || slopes.fall_mm3_s2 > 0)
      SmoothFlow(slopes, FilamentAreaMm2(options), path);
    // With a material mix, each move has one mix, so no moves are joined into arcs.
    if (options.arc_fitting != ArcFitting::kDisabled && options.material_field.empty())
      FindArcs(path);
    built.push_back({std::move(path), builder.stats(), builder.retracted()});
  }
  return built;
}

BuiltBlock HandOver(const OrderedLayer& layer, const MotionOptions& options) {
  ToolpathBuilder builder(options, layer.frame, layer.frame.height_nm);
  if (layer.begins_ready) builder.BeginAsLeft();
  Toolpath path = builder.Finish();
  return {std::move(path), builder.stats(), builder.retracted()};
}

}  // namespace slicefarm::motion
