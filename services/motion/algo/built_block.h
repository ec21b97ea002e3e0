#pragma once

#include <vector>

#include "common/model/options/motion_options.h"
#include "common/model/path.h"
#include "services/motion/algo/toolpath/toolpath_builder.h"

namespace slicefarm::motion {

/// Moves of a block, with their statistics except times.
struct BuiltBlock {
  Toolpath path;
  ProgramStats stats;
  bool ends_retracted = true;

  /// Returns the last position of the nozzle. With a wipe or a scarf seam it is beyond the end of
  /// the last path.
  Point Exit() const {
    const Move& last = path.moves.back();
    return {FromUm(last.x_um), FromUm(last.y_um)};
  }
};

/// Returns the block that a visit prints.
inline const PathBlock& BlockOf(const BlockVisit& visit, const OrderedLayer& layer) {
  return layer.blocks[static_cast<size_t>(visit.block)];
}

/// Returns the moves of each block of the layer, in the order of `layer.blocks`. `retracted_mm`:
/// length by which the layer below retracts.
std::vector<BuiltBlock> BuildBlocks(const OrderedLayer& layer, const MotionOptions& options,
                                    double retracted_mm);

/// Returns the moves of a layer that prints nothing. If the layer below ends without a retraction,
/// this layer retracts the filament, because the layer above may begin far away.
BuiltBlock HandOver(const OrderedLayer& layer, const MotionOptions& options);

}  // namespace slicefarm::motion
