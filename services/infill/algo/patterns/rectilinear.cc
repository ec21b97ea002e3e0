#include "services/infill/algo/patterns/rectilinear.h"

#include "services/infill/algo/lines/straight_pieces.h"
#include "services/infill/algo/patterns/line_families.h"

namespace slicefarm::infill {

absl::StatusOr<std::vector<Piece>> AlignedRectilinear(const MultiPolygon& region,
                                                      const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kAlignedRectilinear, context));
}

absl::StatusOr<std::vector<Piece>> Zigzag(const MultiPolygon& region,
                                          const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kZigzag, context));
}

absl::StatusOr<std::vector<Piece>> CrossZag(const MultiPolygon& region,
                                            const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kCrossZag, context));
}

absl::StatusOr<std::vector<Piece>> Rectilinear(const MultiPolygon& region,
                                               const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kRectilinear, context));
}

}  // namespace slicefarm::infill
