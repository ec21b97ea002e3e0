#include "services/infill/algo/patterns/crossing_lines.h"

#include "services/infill/algo/lines/straight_pieces.h"
#include "services/infill/algo/patterns/line_families.h"

namespace slicefarm::infill {

absl::StatusOr<std::vector<Piece>> Grid(const MultiPolygon& region, const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kGrid, place));
}

absl::StatusOr<std::vector<Piece>> Triangles(const MultiPolygon& region,
                                             const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kTriangles, place));
}

absl::StatusOr<std::vector<Piece>> Stars(const MultiPolygon& region, const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kStars, place));
}

absl::StatusOr<std::vector<Piece>> Cubic(const MultiPolygon& region, const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kCubic, place));
}

absl::StatusOr<std::vector<Piece>> QuarterCubic(const MultiPolygon& region,
                                                const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kQuarterCubic, place));
}

absl::StatusOr<std::vector<Piece>> LateralLattice(const MultiPolygon& region,
                                                  const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kLateralLattice, place));
}

absl::StatusOr<std::vector<Piece>> LateralHoneycomb(const MultiPolygon& region,
                                                    const PatternPlace& place) {
  return StraightPieces(region, LineFamiliesOf(FillPattern::kLateralHoneycomb, place));
}

}  // namespace slicefarm::infill
