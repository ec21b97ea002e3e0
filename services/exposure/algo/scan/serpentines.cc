#include "services/exposure/algo/scan/serpentines.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "processes/laser/model/exposure_options.h"
#include "services/exposure/algo/scan/scan_lines.h"

namespace slicefarm::exposure {
namespace {

constexpr size_t kNone = SIZE_MAX;

/// Pieces of lines, with the index of each line's first piece, and a mark for used pieces.
class PieceTable {
 public:
  explicit PieceTable(const std::vector<ScanPiece>& pieces)
      : pieces_(pieces), used_(pieces.size()) {
    for (size_t i = 0; i < pieces.size(); ++i)
      if (i == 0 || pieces[i].line != pieces[i - 1].line) begin_.push_back(i);
    begin_.push_back(pieces.size());
    line_of_.resize(pieces.size());
    for (size_t line = 0; line + 1 < begin_.size(); ++line)
      for (size_t i = begin_[line]; i < begin_[line + 1]; ++i) line_of_[i] = line;
  }

  bool Used(size_t piece) const { return used_[piece]; }
  void Use(size_t piece) { used_[piece] = true; }

  /// Returns the unused piece on the next line that is beside `piece`. If several are, returns the
  /// one with the end nearest to `u`.
  size_t NextBeside(size_t piece, double u) const {
    const size_t row = line_of_[piece] + 1;
    if (row + 1 >= begin_.size() || pieces_[begin_[row]].line != pieces_[piece].line + 1)
      return kNone;
    const auto first = pieces_.begin() + static_cast<ptrdiff_t>(begin_[row]);
    const auto last = pieces_.begin() + static_cast<ptrdiff_t>(begin_[row + 1]);
    auto other = std::partition_point(
        first, last, [&](const ScanPiece& p) { return p.u1 <= pieces_[piece].u0; });
    size_t best = kNone;
    double least = 0;
    for (; other != last && other->u0 < pieces_[piece].u1; ++other) {
      const auto index = static_cast<size_t>(other - pieces_.begin());
      const double distance = std::min(std::abs(other->u0 - u), std::abs(other->u1 - u));
      if (used_[index] || (best != kNone && distance >= least)) continue;
      best = index;
      least = distance;
    }
    return best;
  }

 private:
  const std::vector<ScanPiece>& pieces_;
  std::vector<bool> used_;
  std::vector<size_t> begin_;
  std::vector<size_t> line_of_;
};

}  // namespace

absl::StatusOr<LineBlocks> SerpentineBlocks(const HatchRegion& region, double angle_deg,
                                            const ExposureOptions& options) {
  const LineAxes frame = LineAxes::OfDegrees(angle_deg);
  const LineGrid grid{.pitch_nm = static_cast<double>(options.hatch_distance_nm)};
  auto pieces = CutTrimmedLines(region, frame, grid);
  if (!pieces.ok()) return pieces.status();
  std::erase_if(*pieces, [&](const ScanPiece& piece) {
    return piece.u1 - piece.u0 < static_cast<double>(options.minimum_vector_nm);
  });
  LineBlocks blocks;
  blocks.points.reserve(2 * pieces->size());
  PieceTable table(*pieces);
  for (size_t first = 0; first < pieces->size(); ++first) {
    if (table.Used(first)) continue;
    blocks.begin.push_back(blocks.points.size());
    blocks.odd.push_back(blocks.odd.size() % 2 == 1);
    bool forward = true;
    for (size_t i = first; i != kNone;) {
      const ScanPiece& piece = (*pieces)[i];
      table.Use(i);
      const double v = grid.V(piece.line);
      const double end = forward ? piece.u1 : piece.u0;
      blocks.points.push_back(frame.At(forward ? piece.u0 : piece.u1, v));
      blocks.points.push_back(frame.At(end, v));
      i = table.NextBeside(i, end);
      if (i != kNone && options.alternate_directions)
        forward = std::abs((*pieces)[i].u0 - end) <= std::abs((*pieces)[i].u1 - end);
    }
  }
  if (!blocks.begin.empty()) blocks.begin.push_back(blocks.points.size());
  return blocks;
}

}  // namespace slicefarm::exposure
