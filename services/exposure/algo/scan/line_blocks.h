#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {
struct ExposureOptions;
}  // namespace slicefarm

namespace slicefarm::exposure {

/// Hatch lines in blocks that are scanned in one go.
struct LineBlocks {
  std::vector<Point> points;  ///< two a line, in order and direction, block after block
  std::vector<size_t> begin;  ///< of each block in `points`; one more entry than blocks
  std::vector<bool> odd;      ///< by block: the other colour of the chequerboard
};

/// The lines block by block, in the order that options.jump_order asks for. With alternating
/// directions a block may be scanned from its end; against the flow of gas any block, where lines
/// that all run one way keep their directions.
std::vector<Point> InOrder(const LineBlocks& blocks, const ExposureOptions& options, Point from);

}  // namespace slicefarm::exposure
