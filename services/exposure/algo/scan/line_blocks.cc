#include "services/exposure/algo/scan/line_blocks.h"

#include <iterator>

#include "services/exposure/algo/scan/block_order.h"

namespace slicefarm::exposure {

std::vector<Point> InOrder(const LineBlocks& blocks, const ExposureOptions& options, Point from) {
  std::vector<ScanBlock> whole;
  for (size_t b = 0; b + 1 < blocks.begin.size(); ++b) {
    whole.push_back({.start = blocks.points[blocks.begin[b]],
                     .end = blocks.points[blocks.begin[b + 1] - 1],
                     .reversible = options.alternate_directions,
                     .odd = blocks.odd[b]});
  }
  std::vector<Point> points;
  points.reserve(blocks.points.size());
  for (const BlockTurn& turn : OrderBlocks(whole, options.jump_order, from)) {
    const auto first = blocks.points.begin() + static_cast<ptrdiff_t>(blocks.begin[turn.block]);
    const auto last = blocks.points.begin() + static_cast<ptrdiff_t>(blocks.begin[turn.block + 1]);
    if (turn.reversed) {
      points.insert(points.end(), std::make_reverse_iterator(last),
                    std::make_reverse_iterator(first));
    } else {
      points.insert(points.end(), first, last);
    }
  }
  return points;
}

}  // namespace slicefarm::exposure
