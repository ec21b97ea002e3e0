#include "services/infill/algo/patterns/side_by_side.h"

#include <cmath>
#include <span>
#include <utility>

#include "common/geometry/offset/clean_offset.h"
#include "common/geometry/offset/offset.h"
#include "services/infill/algo/lines/clip_curves.h"
#include "services/infill/algo/patterns/line_families.h"
#include "services/infill/algo/patterns/registry.h"

namespace slicefarm::infill {
namespace {

/// Returns the lines of pieces. A closed line ends with its first edge, so that a strip around the
/// line has no gap at its ends.
std::vector<Polyline> LinesOfPieces(std::vector<Piece> pieces) {
  std::vector<Polyline> lines;
  for (Piece& piece : pieces) {
    Polyline& line = lines.emplace_back(std::move(piece.points));
    if (!piece.closed) continue;
    const Point first = line[0], second = line[1];
    line.push_back(first);
    line.push_back(second);
  }
  return lines;
}

/// Returns `count` curves in place of each line, a spacing apart.
std::vector<Curve> ParallelCurves(std::span<const Polyline> lines, int32_t count,
                                  Coord spacing_nm) {
  std::vector<Curve> curves;
  const bool odd = count % 2 != 0;
  if (odd)
    for (const Polyline& line : lines) curves.push_back({line});
  for (int32_t pair = 0; pair < count / 2; ++pair) {
    const double spacings = pair + (odd ? 1.0 : 0.5);
    const Coord distance = std::llround(spacings * static_cast<double>(spacing_nm));
    ForEachRing(OffsetLines(lines, distance, Cap::kButt), [&curves](const Polygon& ring) {
      curves.push_back({ring, true});
    });
  }
  return curves;
}

}  // namespace

absl::StatusOr<std::vector<Piece>> PiecesOfPattern(FillPattern pattern, const MultiPolygon& region,
                                                   const PatternContext& context) {
  const int32_t lines = TakesSeveralLines(pattern) ? context.shape.lines : 1;
  const bool by_itself = lines == 1 || pattern == FillPattern::kConcentric ||
                         !LineFamiliesOf(pattern, context).empty();
  PatternContext wide = context;
  wide.shape.lines = by_itself ? lines : 1;
  if (by_itself || region.empty()) return PatternOf(pattern)(region, wide);
  wide.pitch_nm *= lines;
  wide.spacing_nm *= lines;
  // Ends of strips are outside the region, and strips that reach into the region are complete.
  auto pieces = PatternOf(pattern)(FastOffset(region, wide.spacing_nm), wide);
  if (!pieces.ok()) return pieces.status();
  const std::vector<Polyline> middles = LinesOfPieces(*std::move(pieces));
  return ClipCurves(region, ParallelCurves(middles, lines, context.spacing_nm));
}

}  // namespace slicefarm::infill
