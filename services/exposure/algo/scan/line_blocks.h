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
  std::vector<Point> points;  ///< two points per line, in order and direction, block after block
  /// Index of each block's first point in `points`, plus the end of the last block.
  std::vector<size_t> begin;
  /// True for blocks of the other colour of the chequerboard, indexed by block.
  std::vector<bool> odd;
};

/// Returns the lines block by block, in the order of options.jump_order. With alternating
/// directions a block may be scanned from its end. Against the gas flow any block may be, and lines
/// that all run in one direction keep their direction.
std::vector<Point> InOrder(const LineBlocks& blocks, const ExposureOptions& options, Point from);

}  // namespace slicefarm::exposure
