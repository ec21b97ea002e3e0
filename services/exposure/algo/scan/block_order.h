#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/point.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

/// Unit of a scan that is not interrupted: a stripe, an island or a convex piece.
struct ScanBlock {
  Point start, end;
  Point middle = {};        ///< middle of the block's box; used only by kAgainstGas
  bool reversible = false;  ///< true if the block may be scanned from its end to its start
  bool odd = false;         ///< true for blocks of the second colour of the chequerboard
};

/// A block and its direction, as an element of the scanning order.
struct BlockTurn {
  size_t block = 0;
  bool reversed = false;

  friend bool operator==(const BlockTurn&, const BlockTurn&) = default;
};

/// Returns the order in which blocks are scanned, beginning near `from`.
///   kNearest:      next is the block that begins nearest to the end of the last one;
///   kChequerboard: first all blocks that are not odd, then all odd ones, each set as in kNearest;
///   kFarthest:     next is the block that begins farthest from the end of the last one;
///   kAgainstGas:   by the blocks' middles, against the direction of the gas flow; a reversible
///                  block begins at its end if the end is farther along the flow.
/// If several blocks are tied, the first one is chosen. Cost: O(n log n) in total, n blocks,
/// because the first two methods search blocks in a grid; O(n^2) for kFarthest.
std::vector<BlockTurn> OrderBlocks(const std::vector<ScanBlock>& blocks, JumpOrder order,
                                   Point from, double gas_flow_deg = 0);

/// Returns the centre of a box.
Point MiddleOf(const Box& box);

}  // namespace slicefarm::exposure
