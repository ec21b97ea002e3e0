#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Hatch lines in blocks. Each block is scanned without interruption.
struct LineBlocks {
  /// two points per line; lines in the order and direction of scanning, block after block
  std::vector<Point> points;
  /// Index of each block's first point in `points`; one more entry than blocks.
  std::vector<size_t> begin;
  /// True for blocks of the second colour of the chequerboard, indexed by block.
  std::vector<bool> odd;
};

/// Returns the lines block by block, in the order of options.jump_order, beginning near `from`. A
/// block may be scanned from its end if lines alternate in direction, or if jump_order is
/// kAgainstGas. With kAgainstGas, lines that do not alternate are scanned in reverse order, but
/// each in its own direction.
std::vector<Point> InOrder(const LineBlocks& blocks, const ExposureOptions& options, Point from);

}  // namespace slicefarm::exposure
