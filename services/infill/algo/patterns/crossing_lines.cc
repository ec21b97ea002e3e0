#include "services/infill/algo/patterns/crossing_lines.h"

#include "services/infill/algo/lines/straight_pieces.h"
#include "services/infill/algo/patterns/line_families.h"

namespace slicefarm::infill {

absl::StatusOr<std::vector<Piece>> Grid(const MultiPolygon& region, const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kGrid, context));
}

absl::StatusOr<std::vector<Piece>> Triangles(const MultiPolygon& region,
                                             const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kTriangles, context));
}

absl::StatusOr<std::vector<Piece>> Stars(const MultiPolygon& region,
                                         const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kStars, context));
}

absl::StatusOr<std::vector<Piece>> Cubic(const MultiPolygon& region,
                                         const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kCubic, context));
}

absl::StatusOr<std::vector<Piece>> QuarterCubic(const MultiPolygon& region,
                                                const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kQuarterCubic, context));
}

absl::StatusOr<std::vector<Piece>> LateralLattice(const MultiPolygon& region,
                                                  const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kLateralLattice, context));
}

absl::StatusOr<std::vector<Piece>> LateralHoneycomb(const MultiPolygon& region,
                                                    const PatternContext& context) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kLateralHoneycomb, context));
}

}  // namespace slicefarm::infill
