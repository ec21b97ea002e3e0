#include "services/infill/algo/lines/straight_pieces.h"

namespace slicefarm::infill {

absl::StatusOr<std::vector<Piece>> StraightPieces(const MultiPolygon& region,
                                                  std::span<const LineFamily> families) {
  std::vector<Piece> pieces;
  for (const LineFamily& family : families) {
    const absl::StatusOr<ScanLines> lines = CutLines(region, family);
    if (!lines.ok()) return lines.status();
    pieces.reserve(pieces.size() + static_cast<size_t>(lines->PieceCount()));
    for (int32_t piece = 0; piece < lines->PieceCount(); ++piece) {
      const Crossing& from = lines->crossings[lines->order[2 * piece]];
      const Crossing& to = lines->crossings[lines->order[2 * piece + 1]];
      const Point start = lines->PointOf(from), end = lines->PointOf(to);
      if (start == end) continue;
      pieces.push_back({{start, end}, {from.ring, from.edge}, {to.ring, to.edge}});
    }
  }
  return pieces;
}

}  // namespace slicefarm::infill
