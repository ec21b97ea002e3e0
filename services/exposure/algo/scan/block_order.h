#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/point.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::exposure {

/// What is scanned in one go: a stripe, an island, a convex piece.
struct ScanBlock {
  Point start, end;
  Point middle = {};        ///< of its box; heeded by kAgainstGas alone
  bool reversible = false;  ///< may be scanned from its end to its start
  bool odd = false;         ///< the other colour of the chequerboard
};

struct BlockTurn {
  size_t block = 0;
  bool reversed = false;

  friend bool operator==(const BlockTurn&, const BlockTurn&) = default;
};

/// In which order blocks are scanned, beginning near `from`.
///   kNearest:      always the one that begins nearest to where the last one ended;
///   kChequerboard: all that are not odd by that rule, then all that are;
///   kFarthest:     always the one that begins farthest from where the last one ended;
///   kAgainstGas:   by their middles, against the direction that the gas flows to; blocks that may
///                  be reversed begin at their end if that lies farther that way.
/// Among equal ones the first. Cost: O(n log n) on the whole, as the first two search blocks in a
/// grid; O(n^2) for kFarthest.
std::vector<BlockTurn> OrderBlocks(const std::vector<ScanBlock>& blocks, JumpOrder order,
                                   Point from, double gas_flow_deg = 0);

Point MiddleOf(const Box& box);

}  // namespace slicefarm::exposure
