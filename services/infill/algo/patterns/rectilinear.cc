#include "services/infill/algo/patterns/rectilinear.h"

#include "services/infill/algo/lines/straight_pieces.h"
#include "services/infill/algo/patterns/line_families.h"

namespace slicefarm::infill {

absl::StatusOr<std::vector<Piece>> AlignedRectilinear(const MultiPolygon& region,
                                                      const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kAlignedRectilinear, place));
}

absl::StatusOr<std::vector<Piece>> Zigzag(const MultiPolygon& region, const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kZigzag, place));
}

absl::StatusOr<std::vector<Piece>> CrossZag(const MultiPolygon& region, const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kCrossZag, place));
}

absl::StatusOr<std::vector<Piece>> Rectilinear(const MultiPolygon& region,
                                               const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kRectilinear, place));
}

}  // namespace slicefarm::infill
