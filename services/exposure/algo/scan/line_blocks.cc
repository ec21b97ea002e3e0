#include "services/exposure/algo/scan/line_blocks.h"

#include <iterator>
#include <span>

#include "services/exposure/algo/scan/block_order.h"

namespace slicefarm::exposure {

std::vector<Point> InOrder(const LineBlocks& blocks, const ExposureOptions& options, Point from) {
  const bool against_gas = options.jump_order == JumpOrder::kAgainstGas;
  const std::span<const Point> all = blocks.points;
  std::vector<ScanBlock> whole;
  for (size_t b = 0; b + 1 < blocks.begin.size(); ++b) {
    const auto block = all.subspan(blocks.begin[b], blocks.begin[b + 1] - blocks.begin[b]);
    whole.push_back({.start = block.front(),
                     .end = block.back(),
                     .middle = against_gas ? MiddleOf(Bounds(block)) : Point{},
                     .reversible = options.alternate_directions || against_gas,
                     .odd = blocks.odd[b]});
  }
  std::vector<Point> points;
  points.reserve(blocks.points.size());
  for (const BlockTurn& turn : OrderBlocks(whole, options.jump_order, from, options.gas_flow_deg)) {
    const auto first = blocks.points.begin() + static_cast<ptrdiff_t>(blocks.begin[turn.block]);
    const auto last = blocks.points.begin() + static_cast<ptrdiff_t>(blocks.begin[turn.block + 1]);
    if (turn.reversed && !options.alternate_directions) {
      for (auto line = last; line != first; line -= 2) points.insert(points.end(), line - 2, line);
    } else if (turn.reversed) {
      points.insert(points.end(), std::make_reverse_iterator(last),
                    std::make_reverse_iterator(first));
    } else {
      points.insert(points.end(), first, last);
    }
  }
  return points;
}

}  // namespace slicefarm::exposure
