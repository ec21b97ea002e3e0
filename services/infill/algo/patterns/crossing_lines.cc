#include "services/infill/algo/patterns/crossing_lines.h"

#include <array>
#include <numbers>

#include "services/infill/algo/lines/straight_pieces.h"

namespace slicefarm::infill {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;
constexpr double kThirdTurn = 2 * std::numbers::pi / 3;

/// Three directions that sum to zero; `shift_nm`: how far each lies aside of the origin, to the
/// left of its direction.
absl::StatusOr<std::vector<Piece>> ThreeWays(const MultiPolygon& region, const PatternPlace& place,
                                             const std::array<double, 3>& shift_nm) {
  std::array<LineFamily, 3> families;
  for (size_t i = 0; i < 3; ++i)
    families[i] = {place.angle_rad + static_cast<double>(i) * kThirdTurn, shift_nm[i],
                   3 * place.pitch_nm};
  return StraightPieces(region, families);
}

}  // namespace

absl::StatusOr<std::vector<Piece>> Grid(const MultiPolygon& region, const PatternPlace& place) {
  const LineFamily families[] = {{place.angle_rad, 0, 2 * place.pitch_nm},
                                 {place.angle_rad + kRightAngle, 0, 2 * place.pitch_nm}};
  return StraightPieces(region, families);
}

absl::StatusOr<std::vector<Piece>> Triangles(const MultiPolygon& region,
                                             const PatternPlace& place) {
  return ThreeWays(region, place, {0, 0, 0});
}

absl::StatusOr<std::vector<Piece>> Stars(const MultiPolygon& region, const PatternPlace& place) {
  return ThreeWays(region, place, {0, 0, 1.5 * place.pitch_nm});
}

absl::StatusOr<std::vector<Piece>> Cubic(const MultiPolygon& region, const PatternPlace& place) {
  const double shift = static_cast<double>(place.z_nm) / std::numbers::sqrt2;
  return ThreeWays(region, place, {shift, shift, shift});
}

}  // namespace slicefarm::infill
