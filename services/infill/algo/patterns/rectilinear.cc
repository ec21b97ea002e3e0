#include "services/infill/algo/patterns/rectilinear.h"

#include <numbers>

#include "services/infill/algo/lines/straight_pieces.h"

namespace slicefarm::infill {

absl::StatusOr<std::vector<Piece>> AlignedRectilinear(const MultiPolygon& region,
                                                      const PatternPlace& place) {
  const LineFamily family{place.angle_rad, 0, place.pitch_nm};
  return StraightPieces(region, {&family, 1});
}

absl::StatusOr<std::vector<Piece>> Rectilinear(const MultiPolygon& region,
                                               const PatternPlace& place) {
  PatternPlace turned = place;
  if (place.layer % 2 != 0) turned.angle_rad += std::numbers::pi / 2;
  return AlignedRectilinear(region, turned);
}

}  // namespace slicefarm::infill
